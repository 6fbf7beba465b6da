use lobe_backends::interp::ShadowColumn;
use lobe_codegen::prelude::*;
use lobe_kernels::rect::Rectangle;
use lobe_kernels::rect::laplace::*;
use lobe_tests::domain::Inputs;
use lobe_tests::subject::Subject;

#[kernel]
pub struct Probe {
    pub start: Vec2,
    pub lifted: Vec2,
    pub c1: f32,
    pub s1: f32,
    pub t1: f32,
    pub k1: f32,
    pub l1: f32,
    pub g1: Vec2,
    pub f1: Vec3,
    pub det1: f32,
    pub stepped: Vec2,
    pub at: Vec2,
    pub along: Vec2,
    pub down: f32,
    pub c2: f32,
    pub s2: f32,
    pub t2: f32,
    pub fa: f32,
    pub fb: f32,
    pub g2: Vec2,
    pub f2: Vec3,
    pub low: Vec2,
    pub high: Vec2,
    pub secant: Vec2,
    pub g: Vec2,
    pub a: f32,
    pub c: f32,
    pub share: f32,
    pub area: f32,
}

#[kernel(family = "x", cite = "x", budget(1.0))]
pub fn probe(rectangle: Rectangle, source: Reflector, pixel: Receiver) -> Probe {
    let bitangent = cross(rectangle.normal, rectangle.tangent);
    let reflector = rect_laplace_reflector(rectangle, bitangent, source.alpha, source.light_dir);
    let receiver = rect_laplace_receiver(rectangle, bitangent, pixel);
    let start0 = rect_laplace_start(reflector, receiver);
    let start = rect_laplace_lift(receiver, start0, 0.1);
    let first = rect_laplace_spot(receiver, start);
    let first_a = rect_laplace_reflector_slope(reflector.light, first);
    let first_b = rect_laplace_receiver_slope(receiver, first);
    let ffa = rect_laplace_fall_ggx(first_a.square, reflector.gloss);
    let ffb = rect_laplace_fall_ggx(first_b.square, receiver.gloss);
    let first_form = rect_laplace_form(receiver, first, first_a, ffa, first_b, ffb);
    let aa = first_form.form.x + 4.0;
    let cc = first_form.form.y + 4.0;
    let det1 = aa * cc - first_form.form.z * first_form.form.z;
    let stepped = rect_laplace_step(receiver, first, first_form);
    let at = rect_laplace_lift(receiver, stepped, 0.03);
    let spot = rect_laplace_spot(receiver, at);
    let slope_a = rect_laplace_reflector_slope(reflector.light, spot);
    let slope_b = rect_laplace_receiver_slope(receiver, spot);
    let fall_a = rect_laplace_fall_ggx(slope_a.square, reflector.gloss);
    let fall_b = rect_laplace_fall_ggx(slope_b.square, receiver.gloss);
    let local = rect_laplace_form(receiver, spot, slope_a, fall_a, slope_b, fall_b);
    let own =
        0.5 * reflector.gloss.weight * slope_a.scale * spot.down / (reflector.gloss.square + slope_a.square);
    let extent = rect_laplace_extent(receiver, spot);
    let angles = rect_laplace_angles(spot, local, extent, own);
    let h = angles.share;
    let area = rect_laplace_area_mean(angles, extent, 0.03 + h * (1.24 - 1.29 * h));
    Probe {
        start: start0,
        lifted: start,
        c1: first.cosine,
        s1: first_a.square,
        t1: first_b.square,
        k1: ffa.weight,
        l1: ffb.weight,
        g1: first_form.gradient,
        f1: first_form.form,
        det1,
        stepped,
        at,
        along: spot.along,
        down: spot.down,
        c2: spot.cosine,
        s2: slope_a.square,
        t2: slope_b.square,
        fa: fall_a.value,
        fb: fall_b.value,
        g2: local.gradient,
        f2: local.form,
        low: extent.low,
        high: extent.high,
        secant: extent.secant,
        g: angles.gradient,
        a: angles.a,
        c: angles.c,
        share: angles.share,
        area,
    }
}

fn main() {
    let a: Vec<String> = std::env::args().collect();
    let n: usize = a[1].parse().unwrap();
    let kernels = lobe_codegen::kernels![probe];
    let s = Subject::new(kernels[0]).unwrap();
    let real =
        Subject::new(*lobe_kernels::registry::KERNELS.iter().find(|k| k().name == "rect_laplace").unwrap())
            .unwrap();
    let e = lobe_codegen::data::Columns::zeros(s.program().params().len(), 0);
    let i = Inputs::draw(real.def(), n, a[2].parse().unwrap(), &e).unwrap();
    let names: Vec<String> = s.program().params().iter().map(|p| p.path.clone()).collect();
    let outs: Vec<String> = s.program().results().iter().map(|p| p.path.clone()).collect();
    let all: Vec<String> =
        names.iter().cloned().chain(outs.iter().flat_map(|o| [format!("{o}!"), format!("{o}?")])).collect();
    println!("{},value,bound", all.join(","));
    let mut at = 0;
    while at < n {
        let m = 5000.min(n - at);
        let rows: Vec<Vec<u32>> = (at..at + m).map(|r| i.args.row(r).to_vec()).collect();
        let c = lobe_codegen::data::Columns::from_rows(names.len(), &rows);
        let sh = real.program().shadow(&c, None).unwrap();
        let ShadowColumn::Float { exact, bound, .. } = &sh.columns[0] else { panic!() };
        let lit: Vec<usize> = (0..m).filter(|r| exact[*r] != 0.0).collect();
        let litrows: Vec<Vec<u32>> = lit.iter().map(|r| rows[*r].clone()).collect();
        let c = lobe_codegen::data::Columns::from_rows(names.len(), &litrows);
        let probed = s.program().shadow(&c, None).unwrap();
        for (k, r) in lit.iter().enumerate() {
            let mut v: Vec<String> = litrows[k].iter().map(|w| f32::from_bits(*w).to_string()).collect();
            for col in &probed.columns {
                let ShadowColumn::Float { exact, bound, .. } = col else { panic!() };
                v.push(format!("{:e}", exact[k]));
                v.push(format!("{:e}", bound[k]));
            }
            println!("{},{:e},{:e}", v.join(","), exact[*r], bound[*r]);
        }
        at += m;
    }
}
