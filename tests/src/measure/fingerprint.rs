//! What a figure depends on, in few characters: the definition that was measured, and the driver.

use crate::domain::slots;
use crate::judge::JudgeError;
use crate::subject::Subject;
use lobe_backends::executor::Program;
use lobe_backends::routes::Machine;
use lobe_codegen::ValidModule;
use lobe_codegen::emit::{EmitError, Options, Target, emit};
use std::fmt::Write;

/// The fingerprint of a kernel: of its WGSL without comments, its domain and its budgets.
///
/// The documentation is no part of it, since what was measured is shown there.
///
/// # Errors
/// When the domain or a budget does not stand.
pub fn definition(subject: &Subject) -> Result<u64, JudgeError> {
    let def = subject.def();
    let mut text = source_of(subject.program());
    let _ = writeln!(text, "{:?}", slots(def)?);
    for budget in def.contract.budget {
        let _ = writeln!(text, "{} {}", budget.path, source_of(&Program::new(budget.function)?));
    }
    let _ = writeln!(text, "{}", def.contract.truth.is_some());
    Ok(fnv(&text))
}

fn source_of(program: &Program) -> String {
    source(program.module()).unwrap_or_else(|error| format!("{error} {:?}", program.def().source))
}

/// The module as WGSL without comments: what it computes, and nothing else.
///
/// # Errors
/// When it is not portable: a budget need not be, a kernel is, as other tests say.
pub(crate) fn source(module: &ValidModule) -> Result<String, EmitError> {
    let options = Options { docs: false, header: false, ..Options::default() };
    Ok(emit(module, Target::Wgsl, &options)?.content.text().unwrap_or_default().to_owned())
}

/// FNV-1a: it is the same on every machine, and nobody is to be kept from forging it.
fn fnv(text: &str) -> u64 {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    text.bytes().fold(0xcbf2_9ce4_8422_2325, step)
}

/// What decides the results of a driver: it and its version, the device, the translator; and the processor,
/// where that is the device.
pub(crate) fn driver(machine: &Machine, name: &str) -> String {
    let Some(driver) = machine.drivers().iter().find(|d| d.name == name) else { return "unknown".to_owned() };
    let mut text = format!("{}, {}", driver.adapter_name, driver.driver_info);
    if driver.is_software {
        let _ = write!(text, ", {}", processor());
    }
    let _ = match machine.translators().dxc().map(lobe_backends::translate::Dxc::version) {
        Ok((major, minor)) => write!(text, ", DXC {major}.{minor}"),
        Err(_) => write!(text, ", no DXC"),
    };
    text
}

/// The architecture, and what software drivers generate code for.
fn processor() -> String {
    #[cfg_attr(not(target_arch = "x86_64"), allow(unused_mut, reason = "there is nothing to add"))]
    let mut text = std::env::consts::ARCH.to_owned();
    #[cfg(target_arch = "x86_64")]
    for (name, found) in [
        ("fma", is_x86_feature_detected!("fma")),
        ("avx2", is_x86_feature_detected!("avx2")),
        ("avx512f", is_x86_feature_detected!("avx512f")),
    ] {
        if found {
            let _ = write!(text, " {name}");
        }
    }
    text
}
