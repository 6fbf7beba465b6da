//! Values for pipeline-overridable constants.

use crate::support::foreign;
use lobe_backends::interp::{Buffer, InterpError, Interpreter};
use lobe_codegen::foreign::Override;

const TEXT: &str = "
    @id(7) override count: u32 = 4u;
    override scale: f32;
    override twice = count * 2u;
    override on: bool = false;
    var<workgroup> kept: array<f32, twice>;
    @group(0) @binding(0) var<storage, read_write> out: array<f32>;
    @compute @workgroup_size(count)
    fn main(@builtin(local_invocation_index) i: u32) {
        kept[i] = scale;
        kept[i + count] = select(0.5, 0.25, on);
        workgroupBarrier();
        out[i] = kept[count - 1u - i] + kept[twice - 1u] + f32(twice);
    }";

fn run(values: &[(&str, f64)]) -> Result<Vec<f32>, InterpError> {
    let module = foreign(TEXT);
    let overrides = values.iter().map(|(name, value)| Override { name: (*name).to_owned(), value: *value });
    let interpreter = Interpreter::new(&module)?.with_overrides(overrides.collect());
    let mut buffers = [Buffer { group: 0, binding: 0, data: vec![0; 24] }];
    interpreter.run(0, [1, 1, 1], buffers.as_mut_slice())?;
    Ok(buffers[0].data.as_chunks().0.iter().map(|c| f32::from_le_bytes(*c)).collect())
}

#[test]
fn defaults_hold_where_no_value_is_given() {
    assert_eq!(run(&[("scale", 2.0)]).unwrap(), [10.5, 10.5, 10.5, 10.5, 0.0, 0.0]);
}

#[test]
fn numbers_names_sizes_of_workgroups_and_of_arrays_are_values_too() {
    assert_eq!(run(&[("scale", 2.0), ("7", 2.0), ("on", 1.0)]).unwrap(), [6.25, 6.25, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn an_override_without_a_value_is_named() {
    let message = run(&[]).unwrap_err().to_string();
    assert!(message.starts_with("main: ") && message.contains("scale"), "{message}");
}
