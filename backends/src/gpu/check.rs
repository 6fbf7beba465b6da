//! What can be known to fail before any driver is asked.

use std::collections::{BTreeMap, BTreeSet};

use super::pipelines::{binding_type, common_type, fillers};
use super::{Access, Binding, BindingKind, Driver, GpuError, Job, Shader, spirv};
use crate::texture::{Dimension, Format, Kind, Sampler, TextureShape};

/// Checks `job` against itself and against the `limits` of the device that is to run it.
pub(super) fn check(driver: &str, limits: &wgpu::Limits, job: &Job) -> Result<(), GpuError> {
    check_workgroup(driver, limits, job.workgroup_size)?;
    check_groups(driver, limits, job.groups)?;
    let places = check_places(limits, job.bindings)?;
    check_glsl(driver, limits, job)?;
    check_count(driver, limits, job)?;
    check_immediates(driver, limits, job.immediates)?;
    check_elements(job, wgpu::Features::empty())?;
    job.bindings.iter().try_for_each(|binding| check_binding(driver, limits, binding))?;
    match job.shader {
        Shader::Wgsl(_) | Shader::Glsl(_) => Ok(()),
        Shader::Spirv(words) => {
            let checked = spirv::check(words, job.entry, job.workgroup_size, &places);
            checked.map_err(|reason| GpuError::BadSpirv { reason })
        }
    }
}

/// Checks that `driver` reads the storage textures of `job` that are to be read: some crash on formats without a name.
pub(super) fn check_formats(driver: &Driver, job: &Job) -> Result<(), GpuError> {
    let is_unnamed = |b: &Binding| match b.kind {
        BindingKind::StorageTexture(shape, Access::Read | Access::ReadWrite) => {
            shape.format == Format::Storage(naga::StorageFormat::Bgra8Unorm)
        }
        _ => false,
    };
    if driver.has_unnamed_formats || !job.bindings.iter().any(is_unnamed) {
        return Ok(());
    }
    let feature = "reading of storage textures of format bgra8unorm, for which SPIR-V has no name";
    Err(GpuError::Unsupported { driver: driver.name.clone(), feature })
}

fn bad<T>(reason: impl Into<String>) -> Result<T, GpuError> {
    Err(GpuError::BadJob { reason: reason.into() })
}

fn check_workgroup(driver: &str, limits: &wgpu::Limits, asked: [u32; 3]) -> Result<(), GpuError> {
    let limit = [
        limits.max_compute_workgroup_size_x,
        limits.max_compute_workgroup_size_y,
        limits.max_compute_workgroup_size_z,
    ];
    let total = limits.max_compute_invocations_per_workgroup;
    let invocations: u64 = asked.iter().map(|&n| u64::from(n)).fold(1, u64::saturating_mul);
    if invocations == 0 {
        return bad(format!("workgroup_size is {asked:?}; every axis must be at least 1"));
    }
    if asked.iter().zip(limit).any(|(&asked, limit)| asked > limit) || invocations > u64::from(total) {
        return Err(GpuError::WorkgroupTooLarge { driver: driver.to_owned(), asked, limit, total });
    }
    Ok(())
}

fn check_groups(driver: &str, limits: &wgpu::Limits, asked: [u32; 3]) -> Result<(), GpuError> {
    if asked.contains(&0) {
        return bad(format!("groups is {asked:?}: nothing would run; every axis must be at least 1"));
    }
    let limit = limits.max_compute_workgroups_per_dimension;
    if asked.iter().any(|&n| n > limit) {
        return Err(GpuError::TooManyGroups { driver: driver.to_owned(), asked, limit });
    }
    Ok(())
}

fn check_places(limits: &wgpu::Limits, bindings: &[Binding]) -> Result<BTreeSet<(u32, u32)>, GpuError> {
    let mut taken = BTreeSet::new();
    let mut elements: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    for &Binding { group, binding, element, .. } in bindings {
        if group >= limits.max_bind_groups || binding >= limits.max_bindings_per_bind_group {
            return bad(format!(
                "group {group}, binding {binding} is out of reach: groups end at {}, bindings at {}",
                limits.max_bind_groups - 1,
                limits.max_bindings_per_bind_group - 1
            ));
        }
        let next = elements.entry((group, binding)).or_default();
        match element {
            Some(element) if element != *next => {
                return bad(format!(
                    "group {group}, binding {binding}: element {element} stands where {next} is wanted"
                ));
            }
            Some(_) => *next += 1,
            None => {}
        }
        if !taken.insert((group, binding)) && element.is_none_or(|n| n == 0) {
            return bad(format!("group {group}, binding {binding} is bound twice"));
        }
    }
    Ok(taken)
}

/// Checks that the elements of each binding array can be told by one entry of a layout.
fn check_elements(job: &Job, features: wgpu::Features) -> Result<(), GpuError> {
    let mut types = BTreeMap::new();
    for b in job.bindings.iter().filter(|b| b.element.is_some()) {
        let ty = binding_type(b.kind, features);
        let common = *types.entry((b.group, b.binding)).or_insert(ty);
        let both = [common_type(common, ty), common_type(ty, common)];
        if both[0] != both[1] {
            let Binding { group, binding, .. } = *b;
            return bad(format!("the elements of group {group}, binding {binding} are of different kinds"));
        }
        types.insert((b.group, b.binding), both[0]);
    }
    Ok(())
}

/// Counts the storage buffers, with those that fill the gaps between a SPIR-V shader's.
fn check_count(driver: &str, limits: &wgpu::Limits, job: &Job) -> Result<(), GpuError> {
    let limit = limits.max_storage_buffers_per_shader_stage;
    let is_spirv = matches!(job.shader, Shader::Spirv(_));
    if let Some(high) = job.bindings.iter().find(|b| is_spirv && b.binding >= limit) {
        return bad(format!(
            "binding {} is too high a number for SPIR-V on {driver}: give bindings numbers below {limit}",
            high.binding
        ));
    }
    let groups: BTreeSet<u32> = job.bindings.iter().map(|b| b.group).collect();
    let fillers = groups.into_iter().flat_map(|group| fillers(job, group));
    let fillers = fillers.filter(|filler| filler.kind == BindingKind::StorageRead).count();
    // wgpu counts elements of binding arrays by themselves.
    let storage = |b: &&Binding| {
        b.element.is_none() && matches!(b.kind, BindingKind::StorageRead | BindingKind::StorageReadWrite)
    };
    let own = job.bindings.iter().filter(storage).count();
    if own + fillers > limit as usize {
        return bad(format!(
            "{own} storage buffers and {fillers} unused numbers between bindings are more than the {limit} storage \
             buffers that {driver} binds"
        ));
    }
    Ok(())
}

/// GLSL that is passed through has buffers, without groups, whose numbers wgpu must reach by counting.
fn check_glsl(driver: &str, limits: &wgpu::Limits, job: &Job) -> Result<(), GpuError> {
    if !matches!(job.shader, Shader::Glsl(_)) {
        return Ok(());
    }
    if job.entry != "main" || !job.immediates.is_empty() || job.bindings.iter().any(|b| b.group != 0) {
        return bad("GLSL has one entry point, main, no immediates here, and no groups but 0");
    }
    for binding in job.bindings {
        let most = match binding.kind {
            BindingKind::Uniform => limits.max_uniform_buffers_per_shader_stage,
            BindingKind::StorageRead | BindingKind::StorageReadWrite => {
                limits.max_storage_buffers_per_shader_stage
            }
            BindingKind::Texture(_) | BindingKind::StorageTexture(..) | BindingKind::Sampler(_) => {
                let feature = "textures and samplers in GLSL, only buffers";
                return Err(GpuError::Unsupported { driver: driver.to_owned(), feature });
            }
        };
        if binding.binding >= most {
            return bad(format!(
                "binding {} is too high a number for GLSL on {driver}: give such bindings numbers below {most}",
                binding.binding
            ));
        }
    }
    Ok(())
}

fn check_immediates(driver: &str, limits: &wgpu::Limits, bytes: &[u8]) -> Result<(), GpuError> {
    let limit = limits.max_immediate_size as usize;
    if bytes.len() > limit {
        return bad(format!("{} bytes of immediates are more than the {limit} of {driver}", bytes.len()));
    }
    if !bytes.len().is_multiple_of(4) {
        return bad(format!("{} bytes of immediates are no multiple of 4", bytes.len()));
    }
    Ok(())
}

fn check_binding(driver: &str, limits: &wgpu::Limits, binding: &Binding) -> Result<(), GpuError> {
    match binding.kind {
        BindingKind::Uniform => check_buffer(driver, limits, binding, limits.max_uniform_buffer_binding_size),
        BindingKind::StorageRead | BindingKind::StorageReadWrite => {
            check_buffer(driver, limits, binding, limits.max_storage_buffer_binding_size)
        }
        BindingKind::Texture(shape) => check_texture(limits, binding, &shape),
        BindingKind::StorageTexture(shape, _) => {
            if shape.levels != 1 || shape.format.kind() == Kind::Depth {
                return misfit(binding, &shape, "a storage texture has one level and no depths");
            }
            check_texture(limits, binding, &shape)
        }
        BindingKind::Sampler(sampler) => check_sampler(binding, &sampler),
    }
}

fn misfit(binding: &Binding, shape: &TextureShape, reason: &str) -> Result<(), GpuError> {
    let &Binding { group, binding: number, .. } = binding;
    bad(format!("the texture of {shape} at group {group}, binding {number}: {reason}"))
}

fn check_texture(limits: &wgpu::Limits, binding: &Binding, shape: &TextureShape) -> Result<(), GpuError> {
    if let Err(error) = shape.check(binding.data.len()) {
        return misfit(binding, shape, &error.to_string());
    }
    if shape.samples > 1 && binding.data.iter().any(|byte| *byte != 0) {
        return misfit(binding, shape, "with several samples a texel, only zeros can be sent to a device");
    }
    let depths = binding.data.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes));
    if shape.format == Format::Depth32Float && !depths.into_iter().all(|d| (0.0..=1.0).contains(&d)) {
        return misfit(binding, shape, "a device takes depths from 0 to 1 only");
    }
    let limit = match shape.dimension {
        Dimension::D1 => limits.max_texture_dimension_1d,
        Dimension::D2 | Dimension::D2Array | Dimension::Cube | Dimension::CubeArray => {
            limits.max_texture_dimension_2d
        }
        Dimension::D3 => limits.max_texture_dimension_3d,
    };
    if shape.size.iter().any(|n| *n > limit) || shape.layers > limits.max_texture_array_layers {
        let layers = limits.max_texture_array_layers;
        return misfit(
            binding,
            shape,
            &format!("the driver allows {limit} texels along an axis, {layers} layers"),
        );
    }
    Ok(())
}

fn check_sampler(binding: &Binding, sampler: &Sampler) -> Result<(), GpuError> {
    let &Binding { group, binding: number, data, .. } = binding;
    let [low, high] = sampler.lod;
    let lies =
        (low >= 0.0 && low <= high).then_some(()).ok_or("its levels of detail must be 0 or more, in order");
    let empty = data.is_empty().then_some(()).ok_or("a sampler has no bytes");
    let reason = lies.and(empty).err();
    reason.map_or(Ok(()), |reason| bad(format!("the sampler at group {group}, binding {number}: {reason}")))
}

fn check_buffer(driver: &str, limits: &wgpu::Limits, binding: &Binding, most: u64) -> Result<(), GpuError> {
    let &Binding { group, binding: number, data, .. } = binding;
    let bytes = data.len() as u64;
    if bytes == 0 || !bytes.is_multiple_of(wgpu::COPY_BUFFER_ALIGNMENT) {
        return bad(format!(
            "the buffer at group {group}, binding {number} has {bytes} bytes; it must have some, and a multiple of 4"
        ));
    }
    let limit = most.min(limits.max_buffer_size);
    if bytes > limit {
        let driver = driver.to_owned();
        return Err(GpuError::BufferTooLarge { driver, group, binding: number, bytes, limit });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn job<'a>(workgroup_size: [u32; 3], groups: [u32; 3], bindings: &'a [Binding<'a>]) -> Job<'a> {
        Job { shader: Shader::Wgsl(""), entry: "main", workgroup_size, groups, bindings, immediates: &[] }
    }

    fn storage(group: u32, binding: u32, data: &[u8]) -> Binding<'_> {
        Binding { group, binding, element: None, kind: BindingKind::StorageRead, data }
    }

    #[track_caller]
    fn refused(job: &Job, part: &str) {
        let limits = wgpu::Limits { max_storage_buffer_binding_size: 64, ..Default::default() };
        let message = check("some-driver", &limits, job).expect_err("should be refused").to_string();
        assert!(message.contains(part), "{message}");
    }

    #[test]
    fn a_sound_job_passes() {
        let bindings = [storage(0, 0, &[0; 4]), storage(0, 1, &[0; 8])];
        assert_eq!(check("d", &wgpu::Limits::default(), &job([64, 1, 1], [1; 3], &bindings)), Ok(()));
    }

    #[test]
    fn sizes_that_no_device_runs() {
        refused(&job([0, 1, 1], [1; 3], &[]), "every axis must be at least 1");
        refused(&job([u32::MAX; 3], [1; 3], &[]), "larger than the driver allows");
        refused(&job([16, 16, 2], [1; 3], &[]), "256 in all");
        refused(&job([1; 3], [1, 0, 1], &[]), "nothing would run");
        refused(
            &job([1; 3], [1, 65_536, 1], &[]),
            "some-driver: [1, 65536, 1] workgroups are more than the 65535",
        );
    }

    #[test]
    fn immediates_that_no_device_takes() {
        let with = |immediates| Job { immediates, ..job([1; 3], [1; 3], &[]) };
        refused(&with(&[0; 4]), "4 bytes of immediates are more than the 0 of some-driver");
        let limits = wgpu::Limits { max_immediate_size: 8, ..Default::default() };
        assert_eq!(check("d", &limits, &with(&[0; 8])), Ok(()));
        assert!(check("d", &limits, &with(&[0; 6])).is_err());
    }

    #[test]
    fn buffers_that_no_device_binds() {
        refused(&job([1; 3], [1; 3], &[storage(0, 0, &[])]), "has 0 bytes");
        refused(&job([1; 3], [1; 3], &[storage(0, 3, &[0; 6])]), "group 0, binding 3 has 6 bytes");
        refused(&job([1; 3], [1; 3], &[storage(0, 0, &[0; 68])]), "68 bytes, the driver allows 64");
        refused(&job([1; 3], [1; 3], &[storage(9, 0, &[0; 4])]), "groups end at 3");
        refused(&job([1; 3], [1; 3], &[storage(0, 0, &[0; 4]), storage(0, 0, &[0; 4])]), "bound twice");
    }

    #[test]
    fn textures_and_samplers_that_no_device_binds() {
        let flat = TextureShape::new(Format::Depth32Float, Dimension::D2, [2, 1, 1]);
        let texture = |kind, data| [Binding { group: 0, binding: 5, element: None, kind, data }];

        let cases = [
            (BindingKind::Texture(flat), [0; 4].as_slice(), "has 8 bytes, but 4 were given"),
            (BindingKind::Texture(flat), &[0xff; 8], "depths from 0 to 1"),
            (BindingKind::Texture(TextureShape { samples: 4, ..flat }), &[1; 32], "only zeros"),
            (BindingKind::StorageTexture(flat, Access::Write), &[0; 8], "no depths"),
            (
                BindingKind::Texture(TextureShape { size: [1 << 20, 1, 1], ..flat }),
                &[0; 1 << 22],
                "texels along",
            ),
            (BindingKind::Sampler(Sampler { lod: [2.0, 1.0], ..Sampler::default() }), &[], "in order"),
            (BindingKind::Sampler(Sampler::default()), &[0], "no bytes"),
        ];
        for (kind, data, part) in cases {
            let bindings = texture(kind, data);
            refused(&job([1; 3], [1; 3], &bindings), part);
        }
    }

    #[test]
    fn elements_of_binding_arrays_are_of_one_kind_and_in_order() {
        let element = |number, kind| Binding { element: Some(number), kind, ..storage(0, 2, &[0; 4]) };
        let read = |number| element(number, BindingKind::StorageRead);
        let limits = wgpu::Limits::default();
        let many: Vec<_> = (0..20).map(read).collect();
        assert_eq!(
            check("d", &limits, &job([1; 3], [1; 3], &many)),
            Ok(()),
            "they are no buffers of their own"
        );
        refused(&job([1; 3], [1; 3], &[read(0), read(2)]), "element 2 stands where 1 is wanted");
        refused(&job([1; 3], [1; 3], &[read(1)]), "element 1 stands where 0 is wanted");
        refused(&job([1; 3], [1; 3], &[read(0), storage(0, 2, &[0; 4])]), "bound twice");
        refused(&job([1; 3], [1; 3], &[storage(0, 2, &[0; 4]), read(0)]), "bound twice");
        let mixed = [read(0), element(1, BindingKind::StorageReadWrite)];
        refused(&job([1; 3], [1; 3], &mixed), "group 0, binding 2 are of different kinds");
        let nearest = Binding { data: &[], ..element(0, BindingKind::Sampler(Sampler::default())) };
        let linear = Sampler { minify: crate::texture::Filter::Linear, ..Sampler::default() };
        let linear = Binding { kind: BindingKind::Sampler(linear), element: Some(1), ..nearest };
        assert_eq!(check("d", &limits, &job([1; 3], [1; 3], &[nearest, linear])), Ok(()));
    }

    #[test]
    fn more_buffers_than_a_device_binds() {
        // By default 8 storage buffers a shader.
        let many: Vec<_> = (0..9).map(|number| storage(0, number, &[0; 4])).collect();
        refused(&job([1; 3], [1; 3], &many), "9 storage buffers and 0 unused numbers");
        let high = [storage(0, 8, &[0; 4])];
        let sparse = [storage(0, 7, &[0; 4]), storage(1, 3, &[0; 4])];
        let spirv = |bindings| Job { shader: Shader::Spirv(&[]), ..job([1; 3], [1; 3], bindings) };
        refused(&spirv(&high), "binding 8 is too high a number for SPIR-V on some-driver");
        refused(&spirv(&sparse), "2 storage buffers and 10 unused numbers");
    }
}
