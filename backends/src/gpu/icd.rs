//! Opens one Vulkan driver library directly, as the Vulkan loader would, but without the loader.
//!
//! A driver ("ICD") exports `vk_icdGetInstanceProcAddr`, and every other function is reached through it.
//! So a driver in a folder of ours needs neither an environment variable nor an installed loader to be used.
#![allow(unsafe_code, reason = "a driver is a C library that is loaded at run time")]

use std::fs;
use std::path::{Path, PathBuf};

use ash::vk;
use wgpu::hal::vulkan;

use crate::translate::elf;

/// The manifests (`*.json`) in `folder`, sorted by name; none if there is no such folder.
pub(super) fn manifests(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut manifests: Vec<PathBuf> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    manifests.sort();
    manifests
}

/// An instance on which the driver of `manifest` is the only one.
pub(super) fn instance(manifest: &Path) -> Result<wgpu::Instance, String> {
    let library = library_path(manifest)?;
    let entry = load(&library).map_err(|reason| format!("{}: {reason}", library.display()))?;
    let hal = hal_instance(entry).map_err(|reason| format!("{}: {reason}", library.display()))?;
    // SAFETY: the instance was made just above, and nobody else holds it.
    Ok(unsafe { wgpu::Instance::from_hal::<wgpu::hal::api::Vulkan>(hal) })
}

/// Whether a shader may read storage images whose format it does not state; wgpu does not ask.
pub(super) fn reads_without_format(adapter: &wgpu::Adapter) -> bool {
    // SAFETY: the device is asked for what it can do, and nothing of it is kept or ended.
    let features = unsafe {
        adapter.as_hal::<wgpu::hal::api::Vulkan>().map(|hal| {
            hal.shared_instance().raw_instance().get_physical_device_features(hal.raw_physical_device())
        })
    };
    features.is_some_and(|features| features.shader_storage_image_read_without_format == vk::TRUE)
}

/// The library that a manifest names: absolute, relative to the manifest, or a bare name for the system to find.
fn library_path(manifest: &Path) -> Result<PathBuf, String> {
    let explain = |reason: String| format!("{}: {reason}", manifest.display());
    let text = fs::read_to_string(manifest).map_err(|error| explain(error.to_string()))?;
    let json: serde_json::Value = serde_json::from_str(&text).map_err(|error| explain(error.to_string()))?;
    let name = json["ICD"]["library_path"].as_str().ok_or_else(|| {
        explain("it has no ICD.library_path, so it is no Vulkan driver manifest".to_owned())
    })?;
    let is_bare = !name.contains(['/', '\\']);
    Ok(match manifest.parent() {
        Some(folder) if !is_bare => folder.join(name),
        _ => PathBuf::from(name),
    })
}

fn load(library: &Path) -> Result<ash::Entry, String> {
    elf::check_complete(library)?;
    // SAFETY: loading runs the library's initialisers. It is a Vulkan driver by its manifest, just what the Vulkan
    // loader would load.
    let library = unsafe { libloading::Library::new(library) }.map_err(|error| elf::explain(&error))?;
    // SAFETY: the names and types are those of the loader-driver interface, version 2 and later.
    let get_instance_proc_addr = unsafe {
        if let Ok(negotiate) = library.get::<Negotiate>(b"vk_icdNegotiateLoaderICDInterfaceVersion\0") {
            let mut version = NEWEST_INTERFACE;
            if negotiate(&mut version) != vk::Result::SUCCESS {
                return Err("it speaks none of the driver interface's versions up to 5".to_owned());
            }
        }
        *library
            .get::<vk::PFN_vkGetInstanceProcAddr>(b"vk_icdGetInstanceProcAddr\0")
            .map_err(|error| format!("it is no Vulkan driver: {}", elf::explain(&error)))?
    };
    // Drivers keep threads and thread-local destructors, so their code must never be unmapped.
    std::mem::forget(library);
    // SAFETY: the function belongs to a library that stays loaded.
    Ok(unsafe { ash::Entry::from_static_fn(ash::StaticFn { get_instance_proc_addr }) })
}

/// From version 5 on a driver accepts any API version; newer ones add nothing that is used here.
const NEWEST_INTERFACE: u32 = 5;
type Negotiate = unsafe extern "system" fn(*mut u32) -> vk::Result;

fn hal_instance(entry: ash::Entry) -> Result<vulkan::Instance, String> {
    let flags = wgpu::InstanceFlags::empty();
    // SAFETY: `entry` holds the functions of a loaded driver, and the call has no other precondition.
    let version = unsafe { entry.try_enumerate_instance_version() }
        .map_err(|error| error.to_string())?
        .unwrap_or(vk::API_VERSION_1_0);
    let extensions =
        vulkan::Instance::desired_extensions(&entry, version, flags).map_err(|error| error.to_string())?;
    let names: Vec<_> = extensions.iter().map(|name| name.as_ptr()).collect();
    // wgpu-hal handles Vulkan up to 1.3, and 1.0 drivers refuse to hear of anything newer.
    let api_version = if version < vk::API_VERSION_1_1 { vk::API_VERSION_1_0 } else { vk::API_VERSION_1_3 };
    let application = vk::ApplicationInfo::default().application_name(c"lobe").api_version(api_version);
    let info =
        vk::InstanceCreateInfo::default().application_info(&application).enabled_extension_names(&names);
    // SAFETY: `info` and all that it points to live until the call returns.
    let raw = unsafe { entry.create_instance(&info, None) }.map_err(|error| error.to_string())?;
    let budget = wgpu::MemoryBudgetThresholds::default();
    // SAFETY: `raw` comes from `entry`, with this version and exactly the extensions that wgpu-hal desired; no drop
    // callback, so wgpu-hal owns it from here on.
    unsafe {
        vulkan::Instance::from_raw(entry, raw, version, 0, None, extensions, flags, budget, false, None)
    }
    .map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn refused(manifest: &str, part: &str) {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("driver.json");
        fs::write(&path, manifest).expect("writable");
        fs::write(folder.path().join("broken.so"), "not a library").expect("writable");
        let message = instance(&path).expect_err("should be refused");
        assert!(message.contains(part), "{message}");
    }

    #[test]
    fn broken_manifests_and_libraries_are_named() {
        refused("{", "driver.json: EOF");
        refused("{}", "no ICD.library_path");
        refused(r#"{"ICD": {"library_path": "./missing.so"}}"#, "missing.so: ");
        refused(r#"{"ICD": {"library_path": "./broken.so"}}"#, "broken.so: ");
        // A library, but no driver.
        refused(r#"{"ICD": {"library_path": "libc.so.6"}}"#, "no Vulkan driver");
    }

    #[test]
    fn manifests_are_found_in_order() {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["b.json", "a.json", "notes.txt"] {
            fs::write(folder.path().join(name), "").expect("writable");
        }
        assert_eq!(manifests(folder.path()), ["a.json", "b.json"].map(|name| folder.path().join(name)));
        assert!(manifests(&folder.path().join("absent")).is_empty());
    }
}
