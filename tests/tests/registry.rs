//! Every kernel in the registry is documented, drawable, emitted the same way twice, and mapped to an
//! oracle table or excused.

use lobe_backends::executor::Program;
use lobe_codegen::emit::Target;
use lobe_kernels::registry::{KERNELS, PARTS};
use lobe_tests::cases::Cases;
use lobe_tests::domain::Inputs;
use lobe_tests::oracle::{Mapping, lists, table};

/// Kernels without a table of their own, each with what judges it instead.
const WITHOUT_TABLE: &[(&str, &str)] = &[
    ("expm1_over_x_slope", "its exact function is stated"),
    ("expm1_over_x_higham", "a variant; its exact function is that of expm1_over_x"),
    ("sg_eval_paper", "a variant; equal to sg_eval in exact arithmetic"),
    ("sg_product_paper", "a variant; equal to sg_product in exact arithmetic"),
    ("hsg_steepness", "part of hsg_integral"),
    ("hsg_upper_integral", "expm1_over_x times 2π; hsg_integral along the axis"),
    ("hsg_ratio", "part of hsg_integral"),
    ("hsg_integral_paper", "a variant; equal to hsg_integral in exact arithmetic"),
    ("clamped_cosine", "part of hsg_cosine_product_integral"),
    ("asg_eval_polar", "equal to asg_eval; a test of the family says so"),
    ("asg_eval_polar_paper", "a variant; equal to asg_eval_polar above the horizon"),
    ("asg_width", "part of asg_integral"),
    ("asg_sg_peak", "part of asg_sg_product_integral"),
    ("asg_sg_convolved", "part of asg_sg_product_integral"),
    ("toksvig_spread", "part of moments_of_lobe"),
    ("toksvig_sharpness", "inverse of toksvig_spread; properties"),
    ("toksvig_length_paper", "a variant; equal to 1 - toksvig_spread in exact arithmetic"),
    ("toksvig_sharpness_paper", "a variant; inverse of toksvig_length_paper"),
    ("moments_empty", "part of toksvig_list"),
    ("moments_of_position", "part of vsgl_list"),
    ("moments_of_lobe", "part of toksvig_list"),
    ("moments_merge", "part of toksvig_list"),
    ("moments_merge4", "moments_merge, thrice; properties"),
    ("moments_to_lobe", "part of toksvig_list"),
    ("moments_to_lobe_paper", "a variant; equal to moments_to_lobe in exact arithmetic"),
    ("moments_variance_paper", "a variant; equal to moments_merge in exact arithmetic"),
    ("planar_variance", "part of vsgl_list"),
    ("vsl_cone_paper", "a variant; equal to vsl_cone in exact arithmetic, cancels in f64, too"),
    ("vsl_window", "vsl_cone, as a lobe; properties"),
    ("asg_convolved_at", "part of asg_sg_product_integral"),
    ("product_components", "part of asg_sg_sg_product_integral"),
    ("vsgl_pair_radiance", "asg_sg_sg_product_integral over the cone; properties"),
    ("vsgl_pair_radiance_diffuse", "sg_sg_product_integral over the cone; properties"),
    ("vpl_transfer", "a product of its arguments"),
    ("vpl_radiance", "properties, against vsl_radiance"),
    ("vsl_radiance", "the density of vsl_cone; properties"),
    ("vsgl_transfer_sharpness", "properties"),
    ("vsgl_smoothness", "the solid angle of vsl_cone; properties"),
    ("vsgl_reduce_bias", "a choice of its arguments"),
    ("vsl_radius", "properties"),
    ("brsm_pdf", "properties"),
    ("brsm_texel_pdf", "a product of its arguments"),
    ("brsm_weight", "properties"),
    ("vsgl_intensity", "part of vsgl_list"),
    ("vsgl_from_moments", "part of vsgl_list"),
    ("vsgl_from_moments_paper", "a variant; twice the variance"),
    ("vsgl_distance2", "part of vsgl_incoming"),
    ("vsgl_variance", "part of vsgl_incoming"),
    ("vsgl_region", "part of vsgl_incoming"),
    ("vsgl_incoming_paper", "a variant; equal to vsgl_incoming in exact arithmetic, cancels in f64, too"),
    ("vsgl_light", "part of vsgl_diffuse; properties, against vsgl_incoming"),
    ("vsgl_specular_axis", "the axis of sg_product; properties"),
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
    ("rect_shade", "part of rect_shade_light"),
    ("rect_diffuse_glossy", "a test of the family has its limit"),
    ("polygon_edge", "part of rect_form_factor"),
    ("rect_form_factor", "a test of the family compares it with quadrature"),
    ("rect_diffuse_matt", "a product"),
    ("clamped_cosine_paper", "part of hsg_cosine_product_integral_paper"),
    ("ggx_ndf", "equal to ggx_ndf_cosine in exact arithmetic; a test of the family says so"),
    ("ggx_ndf_between", "ggx_ndf at the half vector; a test of the family says so"),
    ("beckmann_exponent", "part of beckmann_ndf"),
    ("beckmann_ndf", "a test of the family holds it against its formula"),
    ("fresnel_schlick", "a test of the family holds its ends and its bounds"),
    ("fresnel_schlick_between", "fresnel_schlick at the half vector"),
    ("smith_root", "part of smith_g1"),
    ("smith_g1", "a test of the family holds it against its formula and the projected area"),
    ("smith_g2", "part of surface_transfer"),
    ("smith_visibility", "a test of the family holds it against smith_g2"),
    ("orthonormal_frame", "a test of the family holds it against its definition"),
    ("frame_to_world", "a test of the family inverts it"),
    ("frame_to_local", "a test of the family inverts it"),
    ("sine_of_turn", "part of circle_of_turn"),
    ("circle_of_turn", "a test of the family holds it against sine and cosine"),
    ("cosine_sample_hemisphere", "a test of the family holds it against its density"),
    ("cosine_hemisphere_pdf", "a test of the family holds it against samples"),
    ("ggx_sample_half_vector", "a test of the family holds it against its density"),
    ("ggx_half_vector_pdf", "a test of the family holds it against samples"),
    ("ggx_sample_visible_normal", "a test of the family holds it against its density"),
    ("ggx_visible_normal_pdf", "a test of the family holds it against samples"),
    ("mirror", "part of sg_ndf_warp"),
    ("sg_ndf", "a test of the family holds its integrals"),
    ("asg_ndf", "its isotropic case is tested in the family"),
    ("warp_cosine", "part of sg_ndf_warp"),
    ("incidence_tangent", "part of asg_ndf_warp"),
    ("lambert_brdf", "a test of the family makes the whole of the parts"),
    ("microfacet_m", "a test of the family makes the whole of the parts"),
    ("microfacet_reflectance", "a test of the family makes the whole of the parts"),
    ("microfacet_brdf", "tests of the family hold its albedo"),
    ("surface_transfer", "a test of the family makes the whole of the parts"),
    ("surface_brdf_cosine", "a test of the family makes the whole of the parts"),
    ("surface_brdf", "tests of the family hold its symmetry and its parts"),
    ("pcg_hash", "a test of the family holds it against published values"),
    ("pcg3d", "a test of the family holds it against published values"),
    ("pcg4d", "a test of the family holds it against published values"),
    ("uniform_of_bits", "a test of the family holds its ends"),
    ("random_pair", "a test of the family holds its spread"),
    ("running_mean_add", "a test of the family holds it against two passes"),
    ("running_mean_merge", "a test of the family holds it against two passes"),
    ("running_mean_standard_error", "a test of the family holds it against two passes"),
    ("luminance", "a test of the family holds its sum"),
    ("angle_between", "a test of the family holds it against the arc cosine"),
    ("spot_irradiance", "a test of the family holds it against its formula"),
    ("rectangle_point", "a test of the family aims rays at it"),
    ("rectangle_intersect", "a test of the family aims rays at points"),
    ("rectangle_is_met", "a test of the family aims rays at points"),
    ("one_bounce_cosines", "part of one_bounce_ndf_transfer"),
    ("one_bounce_transfer", "a test of the family holds it against the printed formulas"),
    ("one_bounce_area_integrand", "a test of the family holds it against the printed formulas"),
    ("one_bounce_ndf_transfer", "a test of the family integrates it against quadrature"),
    ("one_bounce_sample", "a test of the family integrates by it against quadrature"),
    ("one_bounce_density", "a test of the family integrates by it against quadrature"),
    ("one_bounce_estimate", "a test of the family integrates it against quadrature"),
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
fn every_part_is_documented_and_judged_within_a_kernel() {
    let text = |kernel: &lobe_codegen::def::FunctionRef| {
        let program = Program::new(*kernel).unwrap_or_else(|e| panic!("{e}"));
        let artifact = program.artifact(Target::Wgsl).unwrap_or_else(|e| panic!("{e}"));
        String::from_utf8_lossy(artifact.content.bytes().as_ref()).into_owned()
    };
    let emitted: Vec<String> = KERNELS.iter().map(text).collect();
    for part in PARTS.iter().map(|k| k()) {
        assert!(!part.docs.is_empty(), "{} has no doc comment", part.name);
        assert!(KERNELS.iter().all(|k| k().name != part.name), "{} is registered twice", part.name);
        let call = format!("fn {}(", part.name);
        assert!(emitted.iter().any(|text| text.contains(&call)), "no kernel calls {}", part.name);
    }
}

#[test]
fn every_mapped_table_is_there_and_every_table_is_mapped() {
    let mapping = Mapping::standard().unwrap_or_else(|e| panic!("{e}"));
    let cases = Cases::standard();
    for entry in &mapping.entries {
        assert!(
            KERNELS.iter().any(|k| k().name == entry.kernel) || lists::find(&entry.kernel).is_some(),
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
