//! Golden images notice a changed constant, say what changed, and judge pictures of passes soundly.

use lobe_backends::executor::Program;
use lobe_backends::routes::Machine;
use lobe_codegen::ValidModule;
use lobe_codegen::module::Meta;
use lobe_codegen::validate::validate;
use lobe_golden::image::Picture;
use lobe_golden::{Distance, Golden, Reviewer, Step, Store};
use lobe_kernels::registry::KERNELS;
use lobe_tests::golden::report::{Change, Item, RouteVerdict, Verdict};
use lobe_tests::golden::{Case, Choice, Opened, Routes, Session, Subject, cases, folder};
use lobe_tests::render::Renderer;
use naga::{Expression, Literal, Module};
use std::path::{Path, PathBuf};

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/scenes")
}

/// The cases of the repository, so small that their truth takes no time.
fn small() -> Vec<Case> {
    let found = cases::read(&folder().join("cases.toml"), &scenes()).expect("cases");
    found.into_iter().map(|case| Case { size: [9, 7], ..case }).collect()
}

fn case(name: &str) -> Case {
    small().into_iter().find(|case| case.name.to_string() == name).expect("a case")
}

/// The module without what is known of it besides, so that it and its mutants are told apart by one literal alone.
fn bare(module: &Module) -> ValidModule {
    validate(module.clone(), Meta::default()).expect("it is valid")
}

/// Every float of the module, and each module with one of them a thousandth more; 0 and what is beyond f32 stay.
fn mutants(module: &Module) -> Vec<(f32, ValidModule)> {
    fn literals(module: &mut Module) -> Vec<&mut f32> {
        let Module { global_expressions, functions, entry_points, .. } = module;
        let of_functions = functions.iter_mut().map(|(_, f)| &mut f.expressions);
        let of_entries = entry_points.iter_mut().map(|entry| &mut entry.function.expressions);
        let arenas = std::iter::once(global_expressions).chain(of_functions).chain(of_entries);
        let all = arenas.flat_map(|arena| arena.iter_mut().map(|(_, expression)| expression));
        let floats = all.filter_map(|expression| match expression {
            Expression::Literal(Literal::F32(value)) => Some(value),
            _ => None,
        });
        floats.filter(|value| **value != 0.0).collect()
    }
    let count = literals(&mut module.clone()).len();
    let mutant = |at: usize| {
        let mut changed = module.clone();
        let literal = literals(&mut changed).swap_remove(at);
        let before = *literal;
        *literal *= 1.0 + 1e-3;
        let is_number = literal.is_finite();
        is_number.then(|| validate(changed, Meta::default()).ok()).flatten().map(|module| (before, module))
    };
    (0..count).filter_map(mutant).collect()
}

/// What a changed constant does to a picture: nothing anywhere, or it is caught.
#[derive(Debug, Default)]
struct Tally {
    caught: usize,
    beyond_bound: usize,
    without_effect: Vec<f32>,
}

impl Tally {
    fn take(&mut self, value: f32, truth: &Golden, mutant: &Golden) {
        let Distance { differing, beyond, .. } = truth.distance(mutant).expect("one size");
        match differing {
            0 => self.without_effect.push(value),
            _ => self.caught += 1,
        }
        self.beyond_bound += usize::from(beyond > 0);
    }
}

/// Of each plot, every constant of its kernel times 1.001. One that is not caught changes no result of the interpreter either:
/// it guards what no argument of the plot needs.
#[test]
fn a_changed_constant_is_caught_in_every_plot_that_it_affects() {
    let mut all = Tally::default();
    for case in small() {
        // Large enough that a change beneath f32 moves some value to the next f32.
        let case = Case { size: [48, 48], ..case };
        let Subject::Plot { kernel, .. } = &case.subject else { continue };
        let kernel = KERNELS.iter().find(|known| known().name == kernel).expect("a kernel");
        let program =
            |module| Program::new(*kernel).expect("a program").with_module(module).expect("the kernel");
        let module = Program::new(*kernel).expect("a program").module().module().clone();
        let plain = Opened::of_program(&case, program(bare(&module))).expect("it opens");
        let (truth, found) = (plain.truth().expect("a truth"), interpreted(&plain));
        let mut tally = Tally::default();
        for (value, mutant) in mutants(&module) {
            let opened = Opened::of_program(&case, program(mutant)).expect("it opens");
            assert_ne!(opened.chain().hash, plain.chain().hash, "{}: {value} is in no hash", case.name);
            let before = tally.caught;
            tally.take(value, &truth, &opened.truth().expect("a truth"));
            assert!(
                tally.caught > before || interpreted(&opened) == found,
                "{}: {value} is not caught",
                case.name
            );
        }
        println!("{}: {tally:?}", case.name);
        assert!(tally.caught > 0, "{}: no constant of it matters", case.name);
        all.caught += tally.caught;
        all.beyond_bound += tally.beyond_bound;
        all.without_effect.extend(tally.without_effect);
    }
    println!("all: {all:?}");
    assert!(all.caught > all.without_effect.len(), "{all:?}");
}

/// The same of a pass of a scene, which says by name what changed.
#[test]
fn a_changed_constant_is_caught_in_a_scene() {
    let case = Case { size: [32, 32], ..case("plates_a010/direct") };
    let pass = "direct_pass";
    let module =
        Renderer::new().expect("passes").pipeline().pass(pass).expect("a pass").module().module().clone();
    let with = |module| Renderer::new().expect("passes").with_module(pass, module).expect("the pass");
    let renderer = with(bare(&module));
    let plain = Opened::new(&case, &renderer).expect("it opens");
    let (truth, found) = (plain.truth().expect("a truth"), interpreted(&plain));
    let mut tally = Tally::default();
    for (value, mutant) in mutants(&module) {
        let renderer = with(mutant);
        let opened = Opened::new(&case, &renderer).expect("it opens");
        assert_eq!(opened.chain().changes(plain.chain()), [pass], "{value}");
        let before = tally.caught;
        tally.take(value, &truth, &opened.truth().expect("a truth"));
        assert!(tally.caught > before || interpreted(&opened) == found, "{value} is not caught");
    }
    println!("{}: {tally:?}", case.name);
    assert!(tally.caught > 4, "{tally:?}");
}

fn interpreted<'r>(opened: &Opened<'r>) -> Picture {
    let mut routes = Routes::new(Machine::look(), vec!["interp".parse().expect("a route")]);
    opened.picture(&mut routes, 0).expect("a picture")
}

struct Folder {
    folder: tempfile::TempDir,
}

impl Folder {
    fn new() -> Self {
        Self { folder: tempfile::tempdir().expect("a folder") }
    }

    fn store(&self) -> Store {
        Store::open(self.folder.path())
    }

    fn check(&self, case: &Case, choice: Choice) -> Item {
        let (renderer, store) = (Renderer::new().expect("passes"), self.store());
        let routes = Routes::new(Machine::look(), vec!["interp".parse().expect("a route")]);
        Session::new(&renderer, &store, routes, choice).check(case).expect("the store")
    }

    fn accept(&self, case: &Case) {
        let step = Step {
            case: case.name.clone(),
            accepts: true,
            reason: "a test".to_owned(),
            chain: None,
            exr: None,
        };
        self.store().carry_out(&[step], &Reviewer::now("somebody")).expect("it is accepted");
    }
}

fn writing() -> Choice {
    Choice { writes_pending: true, ..Choice::default() }
}

/// Missing, accepted, unaffected, changed by the scene's parameters, restated.
#[test]
fn a_golden_lives() {
    let (folder, case) = (Folder::new(), case("plates_a010/rect"));
    let missing = folder.check(&case, writing());
    assert_eq!((missing.verdict, missing.rendered), (Verdict::Missing, true));
    assert_eq!(missing.routes[0].verdict, RouteVerdict::Inside);
    assert_eq!(folder.check(&case, Choice::default()).verdict, Verdict::Missing);
    folder.accept(&case);
    let holds = folder.check(&case, writing());
    assert_eq!((holds.verdict, holds.rendered), (Verdict::Holds, false), "{}", holds.why);
    assert!(holds.proof.as_ref().is_some_and(|proof| proof.contains("rect_pass")), "{:?}", holds.proof);
    assert_eq!(holds.routes[0].change, Change::Same);
    let skipped = folder.check(&case, Choice { only_affected: true, ..writing() });
    assert!(skipped.routes.is_empty() && skipped.verdict == Verdict::Holds && skipped.proof.is_some());
    let again = folder.check(&case, Choice { every_truth: true, ..writing() });
    assert_eq!((again.verdict, again.rendered), (Verdict::Holds, true), "{}", again.why);

    let mut other = case.clone();
    let Subject::Render { settings, .. } = &mut other.subject else { panic!("a scene") };
    settings.radius_factor *= 1.001;
    let changed = folder.check(&other, writing());
    assert_eq!(changed.verdict, Verdict::Changed);
    assert!(changed.why.contains("true values are others; changed: settings"), "{}", changed.why);
    assert_eq!(changed.routes[0].change, Change::Mathematics);
    assert!(folder.store().pending(&case.name).expect("readable").is_some());
    // What was pending is not any more, once everything is as it was.
    folder.check(&case, writing());
    assert!(folder.store().pending(&case.name).expect("readable").is_none());

    let Subject::Render { settings, .. } = &mut other.subject else { panic!("a scene") };
    settings.radius_factor = 3.0;
    settings.samples = 17;
    assert_eq!(
        folder.check(&other, writing()).verdict,
        Verdict::Holds,
        "samples are no parameter of this method"
    );
}

/// A picture whose exact values are known: the sum of two passes.
#[test]
fn what_is_permitted_of_a_sum_is_that_of_its_parts_and_the_addition() {
    let case = case("plates_a010/rect");
    let renderer = Renderer::new().expect("passes");
    let opened = Opened::new(&case, &renderer).expect("it opens");
    let golden = opened.truth().expect("a truth");
    let direct = Opened::new(&self::case("plates_a010/direct"), &renderer)
        .expect("it opens")
        .truth()
        .expect("a truth");
    assert!(golden.truth().iter().zip(direct.truth()).all(|(all, part)| all >= part));
    assert!(golden.permitted().iter().zip(direct.permitted()).all(|(all, part)| all >= part));
    assert_ne!(golden.truth(), direct.truth());
    // What is permitted is of the size of what f32 rounds, not of the values.
    let tight = golden.truth().iter().zip(golden.permitted()).filter(|(t, p)| **p < 1e-3 * t.abs().max(1e-6));
    assert!(tight.count() * 10 > golden.truth().len() * 9);
}

#[test]
fn a_case_that_is_none_fails_and_does_not_stop_the_others() {
    let (folder, mut bad) = (Folder::new(), case("plates_a010/direct"));
    let Subject::Render { file, .. } = &mut bad.subject else { panic!("a scene") };
    *file = PathBuf::from("no-such-scene.json");
    let item = folder.check(&bad, writing());
    assert_eq!(item.verdict, Verdict::Failed);
    assert!(item.why.contains("cannot be read"), "{}", item.why);
    let mut bad = case("plots/ggx_ndf");
    let Subject::Plot { kernel, .. } = &mut bad.subject else { panic!("a plot") };
    *kernel = "no_such_kernel".to_owned();
    assert!(folder.check(&bad, writing()).why.contains("there is no kernel"));
    let mut bad = case("plots/ggx_ndf");
    let Subject::Plot { columns, .. } = &mut bad.subject else { panic!("a plot") };
    columns.argument = "sine".to_owned();
    assert!(folder.check(&bad, writing()).why.contains("has no argument sine; it has cosine, alpha"));
}

/// More pixels without bound than the case allows are no pass.
#[test]
fn pixels_without_bound_are_counted_and_limited() {
    let folder = Folder::new();
    let mut case = case("cornell_l0/rect-laplace-fast");
    case.size = [24, 24];
    folder.check(&case, writing());
    folder.accept(&case);
    assert_eq!(folder.check(&case, writing()).verdict, Verdict::Holds);
    case.most_indeterminate = 0.0;
    let item = folder.check(&case, writing());
    assert_eq!(item.verdict, Verdict::FallsShort);
    assert!(item.why.starts_with("nothing is promised of "), "{}", item.why);
    assert_eq!(item.routes[0].verdict, RouteVerdict::Indeterminate);
}
