//! Which Vulkan and OpenGL drivers there are, and how each is found again when it is opened.

use std::path::PathBuf;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

use naga::valid::Capabilities;
use wgpu_naga_bridge::features_to_naga_capabilities;

use super::device::WANTED;
use super::icd;
use crate::translate;

/// The interface by which a driver is reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Api {
    /// Vulkan, which takes SPIR-V.
    Vulkan,
    /// OpenGL, which takes GLSL.
    OpenGl,
}

impl std::fmt::Display for Api {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Vulkan => "Vulkan",
            Self::OpenGl => "OpenGL",
        })
    }
}

impl Api {
    fn backend(self) -> wgpu::Backends {
        match self {
            Self::Vulkan => wgpu::Backends::VULKAN,
            Self::OpenGl => wgpu::Backends::GL,
        }
    }
}

/// A driver together with one device that it drives.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Driver {
    /// Short and stable: `lavapipe`, `swiftshader`, or the device's name as a slug (`nvidia-geforce-rtx-4090`); of an
    /// OpenGL driver `llvmpipe`, or a slug that ends in `-gl`.
    pub name: String,
    /// How it is reached.
    pub api: Api,
    /// The device, as the driver calls it.
    pub adapter_name: String,
    /// The driver and its version, as it states them.
    pub driver_info: String,
    /// The manifest by which the driver is opened without the Vulkan loader; `None` if the loader listed it.
    pub vulkan_icd: Option<PathBuf>,
    /// Whether it runs on the CPU.
    pub is_software: bool,
    /// Whether shaders may use `f64`.
    pub has_f64: bool,
    /// Whether its own language, SPIR-V or GLSL, can be handed to it unchanged.
    pub has_passthrough: bool,
    /// What shaders may use beyond what every device has.
    pub capabilities: Capabilities,
    /// Whether shaders may read storage textures of formats that SPIR-V has no name for.
    pub has_unnamed_formats: bool,
    /// Tells apart several devices of the same name: their place among those of one source.
    index: usize,
}

/// The Vulkan drivers of this machine: lavapipe first, then other CPU drivers, then real GPUs.
///
/// Empty where there are none. Takes some ten milliseconds, for each driver is loaded to ask it for its devices.
#[must_use]
pub fn drivers() -> Vec<Driver> {
    let mut found = listed(Api::Vulkan, None);
    for manifest in tool_manifests() {
        let mut more = listed(Api::Vulkan, Some(manifest));
        more.retain(|new| !new.is_software || found_by_name(&found, &new.name).is_none());
        found.append(&mut more);
    }
    found.sort_by_key(|driver| (driver.name != "lavapipe", !driver.is_software));
    number_twins(&mut found);
    found
}

/// The OpenGL drivers of this machine that have compute shaders.
///
/// Empty where there is no EGL, which is looked for at run time. A context is made to ask each for its device, so it
/// takes longer than [`drivers`].
#[must_use]
pub fn gl_drivers() -> Vec<Driver> {
    let mut found = listed(Api::OpenGl, None);
    found.retain(|driver| driver.has_passthrough);
    number_twins(&mut found);
    found
}

fn found_by_name<'a>(drivers: &'a [Driver], name: &str) -> Option<&'a Driver> {
    drivers.iter().find(|driver| driver.name == name)
}

fn tool_manifests() -> Vec<PathBuf> {
    translate::tools_dir().map(|tools| icd::manifests(&tools.join("vulkan/icd.d"))).unwrap_or_default()
}

/// The devices of one source; a source that does not open has none.
fn listed(api: Api, vulkan_icd: Option<PathBuf>) -> Vec<Driver> {
    let adapters = adapters(api, vulkan_icd.as_ref()).unwrap_or_default();
    let describe = |(index, adapter)| describe(adapter, api, vulkan_icd.clone(), index);
    adapters.iter().enumerate().map(describe).collect()
}

fn adapters(api: Api, vulkan_icd: Option<&PathBuf>) -> Result<Vec<wgpu::Adapter>, String> {
    let instance = match vulkan_icd {
        Some(manifest) => icd::instance(manifest)?,
        None => wgpu::Instance::new(wgpu::InstanceDescriptor {
            backends: api.backend(),
            flags: wgpu::InstanceFlags::empty(),
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        }),
    };
    Ok(block_on(instance.enumerate_adapters(api.backend())))
}

fn describe(adapter: &wgpu::Adapter, api: Api, vulkan_icd: Option<PathBuf>, index: usize) -> Driver {
    let info = adapter.get_info();
    let features = adapter.features();
    Driver {
        name: short_name(api, &info.name, &info.driver),
        api,
        driver_info: format!("{} {}", info.driver, info.driver_info).trim().to_owned(),
        adapter_name: info.name,
        vulkan_icd,
        is_software: info.device_type == wgpu::DeviceType::Cpu,
        has_f64: features.contains(wgpu::Features::SHADER_F64),
        has_passthrough: features.contains(wgpu::Features::PASSTHROUGH_SHADERS),
        capabilities: features_to_naga_capabilities(
            features & WANTED,
            adapter.get_downlevel_capabilities().flags,
        ),
        has_unnamed_formats: api == Api::Vulkan && icd::reads_without_format(adapter),
        index,
    }
}

/// Names that do not change with the LLVM version or the CPU's vector width, for routes and reports are keyed by them.
fn short_name(api: Api, adapter: &str, driver: &str) -> String {
    let is_llvmpipe = adapter.starts_with("llvmpipe");
    match api {
        Api::OpenGl if is_llvmpipe => "llvmpipe".to_owned(),
        Api::OpenGl => format!("{}-gl", slug(adapter)),
        Api::Vulkan => vulkan_name(adapter, driver),
    }
}

fn vulkan_name(adapter: &str, driver: &str) -> String {
    if driver == "llvmpipe" || adapter.starts_with("llvmpipe") {
        "lavapipe".to_owned()
    } else if adapter.starts_with("SwiftShader") {
        "swiftshader".to_owned()
    } else {
        slug(adapter)
    }
}

fn slug(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("-")
}

/// Two equal cards become `card` and `card-2`.
fn number_twins(drivers: &mut [Driver]) {
    for at in 1..drivers.len() {
        let (before, rest) = drivers.split_at_mut(at);
        let base = rest[0].name.clone();
        let mut number = 2;
        while found_by_name(before, &rest[0].name).is_some() {
            rest[0].name = format!("{base}-{number}");
            number += 1;
        }
    }
}

/// The adapter behind `driver`.
pub(super) fn adapter(driver: &Driver) -> Result<wgpu::Adapter, String> {
    let adapter = adapters(driver.api, driver.vulkan_icd.as_ref())?.into_iter().nth(driver.index);
    adapter
        .filter(|adapter| adapter.get_info().name == driver.adapter_name)
        .ok_or_else(|| format!("the device `{}` is not there any more", driver.adapter_name))
}

/// wgpu's futures are ready at once outside the browser; this waits all the same should one not be.
pub(super) fn block_on<T>(future: impl Future<Output = T>) -> T {
    let mut future = pin!(future);
    let mut context = Context::from_waker(Waker::noop());
    loop {
        if let Poll::Ready(value) = future.as_mut().poll(&mut context) {
            return value;
        }
        std::thread::yield_now();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> Driver {
        Driver {
            name: name.to_owned(),
            api: Api::Vulkan,
            adapter_name: String::new(),
            driver_info: String::new(),
            vulkan_icd: None,
            is_software: false,
            has_f64: false,
            has_passthrough: false,
            capabilities: Capabilities::empty(),
            has_unnamed_formats: false,
            index: 0,
        }
    }

    #[test]
    fn names_are_short_and_stable() {
        assert_eq!(short_name(Api::Vulkan, "llvmpipe (LLVM 15.0.6, 256 bits)", "llvmpipe"), "lavapipe");
        assert_eq!(
            short_name(Api::Vulkan, "SwiftShader Device (Subzero)", "SwiftShader driver"),
            "swiftshader"
        );
        assert_eq!(
            short_name(Api::Vulkan, "NVIDIA GeForce RTX 4090 (AD102)", "NVIDIA"),
            "nvidia-geforce-rtx-4090-ad102"
        );
        assert_eq!(short_name(Api::OpenGl, "llvmpipe (LLVM 15.0.6, 256 bits)", ""), "llvmpipe");
        assert_eq!(
            short_name(Api::OpenGl, "NVIDIA GeForce RTX 4090/PCIe/SSE2", ""),
            "nvidia-geforce-rtx-4090-pcie-sse2-gl"
        );
    }

    #[test]
    fn twins_are_numbered() {
        let mut drivers = ["a", "b", "a", "a"].map(named);
        number_twins(&mut drivers);
        assert_eq!(drivers.map(|driver| driver.name), ["a", "b", "a-2", "a-3"]);
    }
}
