//! GLSL for Vulkan: every resource has the group and binding that the module gives it.

use crate::ValidModule;
use crate::emit::{EmitError, Target, glsl};
use naga::back::glsl::WriterFlags;
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};

/// The module with its entry point `index` as `main`.
pub(super) fn write(module: &ValidModule, index: usize) -> Result<String, EmitError> {
    let mut numbered = module.module().clone();
    let mut places = Vec::new();
    for (_, global) in numbered.global_variables.iter_mut() {
        if let Some(place) = &mut global.binding {
            places.push(*place);
            // The writer has room for one number; it becomes two again below.
            *place = naga::ResourceBinding { group: 0, binding: places.len() as u32 - 1 };
        }
    }
    let entry = numbered.entry_points[index].name.clone();
    let policies = BoundsCheckPolicies {
        image_load: BoundsCheckPolicy::ReadZeroSkipWrite,
        ..BoundsCheckPolicies::default()
    };
    let flags = WriterFlags::empty();
    let text = glsl::translate(&mut numbered, module.info(), Target::Glsl, &entry, flags, policies)?;
    let text = glsl::without_core(&text);
    Ok(text.lines().fold(String::new(), |text, line| text + &with_group(line, &places) + "\n"))
}

/// The line, with the group and binding of what it declares.
fn with_group(line: &str, places: &[naga::ResourceBinding]) -> String {
    let declared = line.strip_prefix("layout(").and_then(|rest| rest.split_once("binding = "));
    let Some((before, rest)) = declared else { return line.to_owned() };
    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    match rest[..end].parse::<usize>().ok().and_then(|number| places.get(number)) {
        Some(place) => {
            let (group, binding) = (place.group, place.binding);
            format!("layout({before}set = {group}, binding = {binding}{}", &rest[end..])
        }
        None => line.to_owned(),
    }
}
