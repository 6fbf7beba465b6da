//! `lobe bench --emitted`: what emitted code costs beside hand-written code, and what its emission costs.

use super::{Args, SCHEMA};
use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use lobe_backends::gpu::Gpu;
use lobe_backends::routes::Machine;
use lobe_backends::translate::{Dxc, Slang, TranslateError};
use lobe_tests::overhead::{self, Cost, Emission, GOAL, LISTINGS, Listing};

/// The driver that times are of.
const DRIVER: &str = "lavapipe";

/// Rows, unless said otherwise.
const ROWS: u32 = 1 << 20;

/// Measures all listings.
pub(super) fn run(args: &Args) -> Result<Outcome, Fail> {
    let machine = Machine::look();
    let driver = machine.drivers().iter().find(|driver| driver.name == DRIVER);
    let driver = driver.ok_or_else(|| missing(DRIVER, "`lobe doctor` says how to get it".to_owned()))?;
    let mut gpu = Gpu::open(driver).map_err(|cause| missing(DRIVER, cause.to_string()))?;
    let not_here = |tool: &'static str| move |cause: TranslateError| missing(tool, cause.to_string());
    let dxc = Dxc::find().map_err(not_here("hlsl+dxc"))?;
    let slang = Slang::find().map_err(not_here("hlsl+slang"))?;
    let rows = args.items.unwrap_or(ROWS) as usize;
    let mut outcome = Outcome::Holds;
    for listing in &LISTINGS {
        let costs = overhead::measure(listing, &dxc, &mut gpu, rows, args.rounds.into())?;
        output::print(&render(&costs, args.format))?;
        if args.floor && !holds(&costs) && !holds_again(listing, &dxc, &mut gpu, args, rows)? {
            outcome = Outcome::FellShort;
        }
    }
    for listing in &LISTINGS {
        let emission = overhead::emission(listing, &listing.program()?, &slang, args.rounds.into())?;
        output::print(&render_emission(&emission, args.format))?;
        if args.floor && emission.ratio < GOAL {
            outcome = Outcome::FellShort;
        }
    }
    Ok(outcome)
}

fn missing(route: &str, what: String) -> Fail {
    Fail::Missing { route: route.to_owned(), what }
}

fn holds(costs: &[Cost]) -> bool {
    costs.iter().all(|cost| cost.is_lean() && cost.is_fast())
}

/// A machine that was busy for a while is no fault of the code's.
fn holds_again(listing: &Listing, dxc: &Dxc, gpu: &mut Gpu, args: &Args, rows: usize) -> Result<bool, Fail> {
    eprintln!("lobe: {}: MEASURED A SECOND TIME, which decides", listing.kernel);
    let costs = overhead::measure(listing, dxc, gpu, rows, args.rounds.into())?;
    output::print(&render(&costs, args.format))?;
    Ok(holds(&costs))
}

fn render(costs: &[Cost], format: ListFormat) -> String {
    match format {
        ListFormat::Json => costs.iter().map(|cost| output::json_line(SCHEMA, cost)).collect(),
        ListFormat::Human => costs.iter().map(human).collect(),
    }
}

fn human(cost: &Cost) -> String {
    let Cost { kernel, part, instructions, rows, differing_rows, .. } = cost;
    let short = match (cost.is_lean(), cost.is_fast()) {
        (true, true) => "",
        (true, false) => "  SLOWER",
        (false, _) => "  SHORT",
    };
    format!(
        "{kernel:28} {:8} SPIR-V {:4} DXIL {:4} {:.3} x hand  {:8.3} ms {:.3} x hand  {differing_rows} of {rows} rows \
         differ{short}\n",
        part.name(),
        instructions.spirv,
        instructions.dxil,
        cost.instructions_to_hand,
        cost.seconds * 1e3,
        cost.time_to_hand,
    )
}

fn render_emission(emission: &Emission, format: ListFormat) -> String {
    if let ListFormat::Json = format {
        return output::json_line(SCHEMA, emission);
    }
    let targets: String =
        emission.seconds.iter().map(|(target, seconds)| format!(" {target} {:.3}", seconds * 1e3)).collect();
    format!(
        "{:28} emission, ms:{targets}; slang {:.1}, {:.0} x the slowest\n",
        emission.kernel,
        emission.slang_seconds * 1e3,
        emission.ratio
    )
}
