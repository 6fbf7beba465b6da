//! Every kernel in the registry is documented, drawable, emitted the same way twice, and mapped to an
//! oracle table or excused.

use lobe_backends::executor::Program;
use lobe_codegen::emit::Target;
use lobe_kernels::registry::KERNELS;
use lobe_tests::cases::Cases;
use lobe_tests::domain::Inputs;
use lobe_tests::oracle::{Mapping, table};

/// Kernels without a table of their own, each with what judges it instead.
const WITHOUT_TABLE: &[(&str, &str)] = &[
    ("expm1_over_x_slope", "its exact function is stated"),
    ("expm1_over_x_higham", "a variant; its exact function is that of expm1_over_x"),
    ("sg_eval_paper", "a variant; equal to sg_eval in exact arithmetic"),
    ("sg_product_paper", "a variant; equal to sg_product in exact arithmetic"),
    ("hsg_steepness", "part of hsg_integral"),
    ("hsg_upper_integral", "part of hsg_integral"),
    ("hsg_ratio", "part of hsg_integral"),
    ("hsg_integral_paper", "a variant; equal to hsg_integral in exact arithmetic"),
    ("clamped_cosine", "part of hsg_cosine_product_integral"),
    ("asg_eval_polar", "equal to asg_eval; a test of the family says so"),
    ("asg_eval_polar_paper", "a variant; equal to asg_eval_polar above the horizon"),
    ("asg_width", "part of asg_integral"),
    ("asg_sg_peak", "part of asg_sg_product_integral"),
    ("asg_sg_convolved", "part of asg_sg_product_integral"),
    ("angle_over_sine", "its exact function is stated"),
    ("arctangent", "its exact function is stated"),
    ("circle_segment", "its exact function is stated"),
    ("log1p_over_x", "its exact function is stated"),
    ("rect_radiance", "part of rect_reflection"),
    ("rect_radiance_paper", "part of rect_reflection_paper"),
    ("rect_aperture_paper", "a variant; equal to rect_aperture in exact arithmetic"),
    ("rect_energy", "part of rect_disk_energy"),
    ("rect_energy_paper", "a variant; equal to rect_energy in exact arithmetic"),
    ("rect_energy_ggx", "a test of the family compares it with quadrature"),
    ("rect_disk_radius", "a rule of our own"),
    ("disk_corner", "part of rect_disk_area"),
    ("disk_block", "part of rect_disk_area"),
    ("rect_coverage", "rect_disk_area over that of the disk"),
    ("rect_coverage_paper", "part of rect_shade_within"),
    ("rect_coverage_bounds", "rect_coverage_paper, limited to 1"),
    ("rect_disk_asg", "parts of its argument"),
    ("rect_bandwidth_paper", "part of rect_lobe"),
    ("rect_bandwidth", "rect_bandwidth_paper, limited"),
    ("rect_bandwidth_slope", "part of rect_shade_within; a test of the family takes the difference"),
    ("rect_disk_frame", "part of rect_asg_from_disk"),
    ("rect_lobe", "part of rect_asg_from_disk"),
    ("rect_reflected", "part of rect_reflection"),
    ("rect_shade_within", "part of rect_shade_light"),
    ("rect_shade_error", "a budget"),
    ("rect_shade", "part of rect_shade_light"),
    ("rect_diffuse_glossy", "a test of the family has its limit"),
    ("polygon_edge", "part of rect_form_factor"),
    ("rect_form_factor", "a test of the family compares it with quadrature"),
    ("rect_form_factor_error", "a budget"),
    ("rect_diffuse_matt", "a product"),
    ("clamped_cosine_paper", "part of hsg_cosine_product_integral_paper"),
];

#[test]
fn every_kernel_is_documented() {
    for kernel in KERNELS.iter().map(|k| k()) {
        assert!(!kernel.docs.is_empty(), "{} has no doc comment", kernel.name);
        assert!(!kernel.contract.family.is_empty(), "{} has no family", kernel.name);
        assert!(!kernel.contract.cite.is_empty(), "{} does not say where its equation stands", kernel.name);
    }
}

#[test]
fn no_two_kernels_share_a_name() {
    let mut names: Vec<&str> = KERNELS.iter().map(|k| k().name).collect();
    names.sort_unstable();
    names.windows(2).for_each(|pair| assert_ne!(pair[0], pair[1]));
}

#[test]
fn every_kernels_inputs_can_be_drawn() {
    let cases = Cases::standard();
    for kernel in KERNELS.iter().map(|k| k()) {
        let listed = cases.listed(kernel).unwrap_or_else(|e| panic!("{e}"));
        let inputs = Inputs::draw(kernel, 100, 7, &listed).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(inputs.args.rows, 100 + listed.rows, "{}", kernel.name);
    }
}

#[test]
fn every_kernel_has_a_table_or_an_excuse() {
    let mapping = Mapping::standard().unwrap_or_else(|e| panic!("{e}"));
    for kernel in KERNELS.iter().map(|k| k().name) {
        let is_mapped = mapping.of_kernel(kernel).next().is_some();
        let is_excused = WITHOUT_TABLE.iter().any(|(name, _)| *name == kernel);
        assert!(
            is_mapped || is_excused,
            "{kernel}: no oracle table is mapped to it (tests/cases/oracle-map/)"
        );
        assert!(!(is_mapped && is_excused), "{kernel} has a table now: remove its excuse");
    }
    for (name, _) in WITHOUT_TABLE {
        assert!(KERNELS.iter().any(|k| k().name == *name), "the excuse for {name} outlived the kernel");
    }
}

#[test]
fn every_mapped_table_is_there_and_every_table_is_mapped() {
    let mapping = Mapping::standard().unwrap_or_else(|e| panic!("{e}"));
    let cases = Cases::standard();
    for entry in &mapping.entries {
        assert!(
            KERNELS.iter().any(|k| k().name == entry.kernel),
            "the mapping names no kernel: {}",
            entry.kernel
        );
        table::read(&cases.table(&entry.function)).unwrap_or_else(|e| panic!("{e}"));
    }
    for path in table::list(&cases.folder().join("oracle")).unwrap_or_else(|e| panic!("{e}")) {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        assert!(
            mapping.entries.iter().any(|e| e.function == stem),
            "{}: mapped to no kernel",
            path.display()
        );
    }
}

#[test]
fn the_same_kernel_gives_the_same_bytes() {
    for kernel in KERNELS {
        let (first, second) = (Program::new(*kernel), Program::new(*kernel));
        let (first, second) =
            (first.unwrap_or_else(|e| panic!("{e}")), second.unwrap_or_else(|e| panic!("{e}")));
        for target in Target::ALL {
            let bytes = |p: &Program| p.artifact(target).unwrap_or_else(|e| panic!("{e}")).content.bytes();
            assert_eq!(bytes(&first), bytes(&second), "{} as {target}", first.name());
        }
    }
}
