use lobe_backends::interp::ShadowColumn;
use lobe_kernels::registry::KERNELS;
use lobe_tests::domain::Inputs;
use lobe_tests::subject::Subject;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let k = KERNELS.iter().find(|k| k().name == a[1]).unwrap();
    let n: usize = a[2].parse().unwrap();
    let s = Subject::new(*k).unwrap();
    let e = lobe_codegen::data::Columns::zeros(s.program().params().len(), 0);
    let i = Inputs::draw(s.def(), n, a[3].parse().unwrap(), &e).unwrap();
    let names: Vec<String> = s.program().params().iter().map(|p| p.path.clone()).collect();
    println!("{},value,bound,permitted", names.join(","));
    let mut at = 0;
    while at < n {
        let m = 5000.min(n - at);
        let rows: Vec<Vec<u32>> = (at..at + m).map(|r| i.args.row(r).to_vec()).collect();
        let c = lobe_codegen::data::Columns::from_rows(names.len(), &rows);
        let sh = s.program().shadow(&c, None).unwrap();
        let p = s.permitted(&c, &sh).unwrap();
        if let ShadowColumn::Float { exact, bound, .. } = &sh.columns[0] {
            for r in 0..m {
                if exact[r] != 0.0 || bound[r] != 0.0 {
                    let v: Vec<String> = rows[r].iter().map(|w| f32::from_bits(*w).to_string()).collect();
                    println!("{},{:e},{:e},{:e}", v.join(","), exact[r], bound[r], p[0].as_ref().unwrap()[r]);
                }
            }
        }
        at += m;
    }
}
