//! A kernel with an error put into one value.

use super::pen::{self, Pen};
use super::record::split;
use super::rewrite::{Known, Probe, rewrite};
use super::{Origin, TraceError};
use crate::ValidModule;
use crate::validate::validate;
use naga::{
    AddressSpace, BinaryOperator, Expression, Function, FunctionResult, GlobalVariable, Handle, Module,
    Scalar, ScalarKind, Statement, TypeInner,
};

/// The module, and the function that takes the error.
#[derive(Debug, Clone)]
pub struct Injected {
    /// The module.
    pub module: ValidModule,
    /// The kernel with three more parameters: `site: u32`, numbered as by [`record`](super::record()), `hit: u32`,
    /// which of its executions is meant, from 0, and `error: f32`, which is added there.
    pub function: Handle<Function>,
}

/// The variables that say where the error goes.
struct Globals {
    site: Handle<GlobalVariable>,
    hit: Handle<GlobalVariable>,
    error: Handle<GlobalVariable>,
    count: Handle<GlobalVariable>,
}

/// The kernel `function` of `module`, taking an error that it adds to one of its values.
///
/// # Errors
/// When it uses something that kernels do not.
pub fn inject(module: &ValidModule, function: Handle<Function>) -> Result<Injected, TraceError> {
    let mut built = Module { functions: Default::default(), doc_comments: None, ..module.module().clone() };
    let [u32, f32] = [Scalar::U32, Scalar::F32].map(|scalar| pen::scalar_type(&mut built, scalar));
    let mut private = |name, ty| pen::variable(&mut built, name, AddressSpace::Private, None, ty);
    let globals = Globals {
        site: private("inject_site", u32),
        hit: private("inject_hit", u32),
        error: private("inject_error", f32),
        count: private("inject_count", u32),
    };
    let injector = injector(&mut built, &globals);
    let mut rewritten = rewrite(module, built, &Injector(injector))?;
    // What is asked is what the formula does, not the function that it approximates.
    rewritten.meta.truths.clear();
    let function = starter(&mut rewritten.module, &globals, rewritten.functions[&function]);
    Ok(Injected { module: validate(rewritten.module, rewritten.meta)?, function })
}

/// `fn inject_error_at(site, value)`, which returns the value, or the value with the error.
fn injector(module: &mut Module, globals: &Globals) -> Handle<Function> {
    let [u32, f32] = [Scalar::U32, Scalar::F32].map(|scalar| pen::scalar_type(module, scalar));
    let mut function = Function { name: Some("inject_at".to_owned()), ..Function::default() };
    function.arguments = vec![pen::parameter("site", u32), pen::parameter("value", f32)];
    function.result = Some(FunctionResult { ty: f32, binding: None });
    let mut pen = Pen::new(&mut function);
    let [site, value] = [0, 1].map(|i| pen.declare(Expression::FunctionArgument(i)));
    let [meant, hit, error, count] = [globals.site, globals.hit, globals.error, globals.count]
        .map(|variable| pen.declare(Expression::GlobalVariable(variable)));
    let one = pen.literal(1);
    let meant = pen.load(meant);
    let is_site = pen.binary(BinaryOperator::Equal, site, meant);
    pen.when(is_site, |pen| {
        let (now, hit) = (pen.load(count), pen.load(hit));
        let next = pen.binary(BinaryOperator::Add, now, one);
        pen.store(count, next);
        let is_hit = pen.binary(BinaryOperator::Equal, now, hit);
        pen.when(is_hit, |pen| {
            let error = pen.load(error);
            let sum = pen.binary(BinaryOperator::Add, value, error);
            pen.push(Statement::Return { value: Some(sum) });
        });
    });
    pen.push(Statement::Return { value: Some(value) });
    pen.finish();
    module.functions.append(function, naga::Span::UNDEFINED)
}

/// The kernel with the error's place as parameters.
fn starter(module: &mut Module, globals: &Globals, kernel: Handle<Function>) -> Handle<Function> {
    let [u32, f32] = [Scalar::U32, Scalar::F32].map(|scalar| pen::scalar_type(module, scalar));
    let callee = &module.functions[kernel];
    let (result, mut arguments) = (callee.result.clone(), callee.arguments.clone());
    let own = arguments.len() as u32;
    arguments.extend(
        [("inject_to", u32), ("inject_nth", u32), ("inject_by", f32)].map(|(n, ty)| pen::parameter(n, ty)),
    );
    let mut function =
        Function { name: Some("inject_start".to_owned()), arguments, result, ..Function::default() };
    let mut pen = Pen::new(&mut function);
    let all: Vec<_> = (0..own + 3).map(|i| pen.declare(Expression::FunctionArgument(i))).collect();
    let zero = pen.literal(0);
    let (arguments, places) = all.split_at(own as usize);
    let variables = [globals.site, globals.hit, globals.error, globals.count];
    for (variable, value) in variables.into_iter().zip(places.iter().copied().chain([zero])) {
        let pointer = pen.declare(Expression::GlobalVariable(variable));
        pen.store(pointer, value);
    }
    let value = pen.declare(Expression::CallResult(kernel));
    pen.push(Statement::Call { function: kernel, arguments: arguments.to_vec(), result: Some(value) });
    pen.push(Statement::Return { value: Some(value) });
    pen.finish();
    module.functions.append(function, naga::Span::UNDEFINED)
}

/// Passes each computed float through the injector.
struct Injector(Handle<Function>);

impl Probe for Injector {
    fn after(&self, pen: &mut Pen<'_>, known: &Known<'_>) -> Handle<Expression> {
        let is_float = known.inner.scalar().is_some_and(|scalar| scalar.kind == ScalarKind::Float);
        // Matrices come from vectors, which had their turn.
        let is_matrix = matches!(known.inner, TypeInner::Matrix { .. });
        if known.origin != Origin::Value || !is_float || is_matrix {
            return known.value;
        }
        let scalars = split(pen, known.value, known.inner);
        let through = (known.first..).zip(scalars).map(|(site, (scalar, _))| {
            let site = pen.literal(site);
            let result = pen.declare(Expression::CallResult(self.0));
            pen.push(Statement::Call {
                function: self.0,
                arguments: vec![site, scalar],
                result: Some(result),
            });
            result
        });
        let components: Vec<_> = through.collect();
        match components[..] {
            [one] => one,
            _ => pen.compute(Expression::Compose { ty: known.ty, components }),
        }
    }
}
