//! What slang sees in the HLSL of a kernel's entry point: workgroup size, places of resources, layouts of structures,
//! parameters and results of functions.

use super::{common, programs};
use lobe_backends::executor::Program;
use lobe_backends::translate::{
    Slang, SlangEntry, SlangFunction, SlangMember, SlangReflection, SlangResource, SlangRules, SlangStructure,
};
use lobe_codegen::emit::reflect::{BindingInfo, EntryPointInfo, FunctionInfo, MemberInfo, StructInfo};
use lobe_codegen::emit::{Reflection, Target, reflect};

fn slang() -> Option<Slang> {
    match Slang::find() {
        Ok(slang) => Some(slang),
        Err(error) => {
            common::skip(&error.to_string(), "run tests/setup.sh");
            None
        }
    }
}

/// What slang sees, without the members that fill a structure up.
fn seen(slang: &Slang, program: &Program, declared: &Reflection, rules: SlangRules) -> SlangReflection {
    let artifact = program.artifact(Target::Hlsl).unwrap_or_else(|e| panic!("{e}"));
    let structures = declared.structs.iter().map(|s| s.name.as_str());
    let names: Vec<&str> = structures.chain(declared.functions.iter().map(|f| f.name.as_str())).collect();
    let text = artifact.content.text().expect("text");
    let entry = &declared.entries[0].name;
    let mut seen = slang.reflect(text, entry, &names, rules).unwrap_or_else(|e| panic!("{e}"));
    seen.structures.iter_mut().for_each(|s| s.members.retain(|m| !m.name.starts_with('_')));
    seen.resources.sort_by_key(|resource| (resource.group, resource.binding));
    seen
}

/// What slang is to see.
fn expected(declared: &Reflection) -> SlangReflection {
    let entry = |e: &EntryPointInfo| SlangEntry {
        name: e.name.clone(),
        workgroup_size: e.workgroup_size.map(|n| n as usize),
    };
    let resource =
        |b: &BindingInfo| SlangResource { name: b.name.clone(), group: b.group, binding: b.binding };
    let member =
        |m: &MemberInfo| SlangMember { name: m.name.clone(), ty: spelled(&m.ty), offset: m.offset as usize };
    let structure = |s: &StructInfo| SlangStructure {
        name: s.name.clone(),
        size: s.size as usize,
        members: s.members.iter().map(member).collect(),
    };
    let function = |f: &FunctionInfo| SlangFunction {
        name: f.name.clone(),
        parameters: f.parameters.iter().map(|p| (p.name.clone(), spelled(&p.ty))).collect(),
        returns: f.returns.as_deref().map_or_else(|| "void".to_owned(), spelled),
    };
    SlangReflection {
        entries: declared.entries.iter().map(entry).collect(),
        resources: declared.entries[0].bindings.iter().map(resource).collect(),
        structures: declared.structs.iter().map(structure).collect(),
        functions: declared.functions.iter().map(function).collect(),
    }
}

/// A type as slang spells it.
fn spelled(ty: &str) -> String {
    match ty {
        "f32" => "float".to_owned(),
        "i32" => "int".to_owned(),
        "u32" => "uint".to_owned(),
        _ => match ty.split_once('<') {
            Some((shape, of)) => composite(shape, of.trim_end_matches('>')),
            None => ty.to_owned(),
        },
    }
}

fn composite(shape: &str, of: &str) -> String {
    match (shape, of.rsplit_once(", ")) {
        ("array", Some((element, n))) => format!("{}[{n}]", spelled(element)),
        _ if shape.starts_with("mat") => {
            let (columns, rows) = (&shape[3..4], &shape[5..6]);
            format!("matrix<{},{columns},{rows}>", spelled(of))
        }
        _ => format!("vector<{},{}>", spelled(of), &shape[3..4]),
    }
}

#[test]
fn hlsl_declares_them_by_slang() {
    let Some(slang) = slang() else { return };
    for program in programs() {
        let (module, _) = program.entry().unwrap_or_else(|e| panic!("{e}"));
        let declared = reflect(module);
        for rules in [SlangRules::Vulkan, SlangRules::Direct3D] {
            let seen = seen(&slang, &program, &declared, rules);
            assert_eq!(seen, expected(&declared), "{} by {rules:?}", program.name());
        }
    }
}

/// Without the members that fill structures up, Direct3D would lay them out closer than hosts do.
#[test]
fn structures_need_their_padding_in_direct3d() {
    let Some(slang) = slang() else { return };
    let bare = "struct Sg { float3 axis; float sharpness; float log_amplitude; };
        [numthreads(1, 1, 1)] void main() {}";
    let size = |rules| {
        let seen = slang.reflect(bare, "main", &["Sg"], rules).unwrap_or_else(|e| panic!("{e}"));
        seen.structures[0].size
    };
    assert_eq!((size(SlangRules::Vulkan), size(SlangRules::Direct3D)), (32, 20));
}

/// Each part of a declaration is compared: one that differs is noticed.
#[test]
fn slang_does_not_see_what_is_not_declared() {
    let Some(slang) = slang() else { return };
    let program = programs().find(|program| program.name() == "sg_product").expect("a kernel");
    let (module, _) = program.entry().unwrap_or_else(|e| panic!("{e}"));
    let declared = reflect(module);
    let seen = seen(&slang, &program, &declared, SlangRules::Direct3D);
    let lies: [fn(&mut Reflection); 7] = [
        |r| r.entries[0].workgroup_size[1] += 1,
        |r| r.entries[0].bindings[0].group += 1,
        |r| r.entries[0].bindings[1].binding += 9,
        |r| r.structs[0].size += 16,
        |r| r.structs[0].members[1].offset += 4,
        |r| r.functions[0].parameters[0].name.push('x'),
        |r| r.functions[0].returns = None,
    ];
    for (i, lie) in lies.iter().enumerate() {
        let mut declared = declared.clone();
        lie(&mut declared);
        assert_ne!(seen, expected(&declared), "lie {i}");
    }
}
