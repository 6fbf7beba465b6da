//! The size of a workgroup as an input, which is GLSL's alone: its value takes its place.

use naga::{
    Arena, BuiltIn, EntryPoint, Expression, Handle, Literal, Module, Scalar, Span, Type, TypeInner,
    VectorSize,
};

/// Replaces the size of a workgroup, where an entry point has it as an argument of its own.
pub(super) fn settle(module: &mut Module) {
    let wanted = Some(naga::Binding::BuiltIn(BuiltIn::WorkGroupSize));
    for index in 0..module.entry_points.len() {
        let arguments = &module.entry_points[index].function.arguments;
        let Some(argument) = arguments.iter().position(|a| a.binding == wanted) else { continue };
        let size = module.entry_points[index].workgroup_size;
        let value = constant(module, size);
        take(&mut module.entry_points[index], argument as u32, value);
    }
}

/// A constant of three numbers.
fn constant(module: &mut Module, numbers: [u32; 3]) -> Handle<naga::Constant> {
    let inner = TypeInner::Vector { size: VectorSize::Tri, scalar: Scalar::U32 };
    let ty = module.types.insert(Type { name: None, inner }, Span::UNDEFINED);
    let globals: &mut Arena<Expression> = &mut module.global_expressions;
    let mut append = |expression| globals.append(expression, Span::UNDEFINED);
    let components = numbers.map(|n| append(Expression::Literal(Literal::U32(n)))).to_vec();
    let init = append(Expression::Compose { ty, components });
    module.constants.append(naga::Constant { name: None, ty, init }, Span::UNDEFINED)
}

/// Puts `value` in the place of an argument.
fn take(point: &mut EntryPoint, argument: u32, value: Handle<naga::Constant>) {
    point.function.arguments.remove(argument as usize);
    for (_, expression) in point.function.expressions.iter_mut() {
        match expression {
            Expression::FunctionArgument(at) if *at == argument => *expression = Expression::Constant(value),
            Expression::FunctionArgument(at) if *at > argument => *at -= 1,
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::foreign::{Language, Source, isolate, read};

    #[test]
    fn the_size_of_a_workgroup_is_a_constant() {
        let text = "#version 450
            layout(local_size_x = 4, local_size_y = 2) in;
            layout(std430, binding = 0) buffer B { uint a[]; } b;
            void main() { b.a[gl_LocalInvocationIndex] = gl_WorkGroupSize.x + gl_WorkGroupID.x; }";
        let (name, bytes) = ("size.comp".to_owned(), text.as_bytes().to_vec());
        let source = Source { name, language: Language::Glsl, bytes };
        let module = isolate(&source, &read(&source).unwrap(), "main", &[]).unwrap();
        let [point] = &module.module().entry_points[..] else { panic!("one entry point") };
        assert_eq!(point.function.arguments.len(), 2);
    }
}
