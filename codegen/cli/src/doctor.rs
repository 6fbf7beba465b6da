//! `lobe doctor`: what this machine has.

use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use lobe_backends::routes::{Machine, State};
use lobe_backends::translate::{self, spirv_val, web};
use serde_json::{Value, json};
use std::fmt::Write;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Form of the output
    #[arg(long, value_enum, default_value_t = ListFormat::Human)]
    format: ListFormat,
}

struct Tool {
    name: &'static str,
    found: Result<String, String>,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let machine = Machine::look();
    let tools = tools(&machine);
    output::print(&match args.format {
        ListFormat::Human => human(&machine, &tools),
        ListFormat::Json => format!("{:#}\n", as_json(&machine, &tools)),
    })?;
    Ok(Outcome::Holds)
}

fn tools(machine: &Machine) -> Vec<Tool> {
    let translators = machine.translators();
    let dxc = translators.dxc().map(|dxc| {
        let (major, minor) = dxc.version();
        format!("{major}.{minor}, {}", dxc.path().display())
    });
    let slang = translators.slang().map(|slang| format!("{}, {}", slang.version(), slang.path().display()));
    let glslang = translators.glslang().map_err(ToString::to_string).and_then(|glslang| {
        let version = glslang.version().map_err(|e| e.to_string())?;
        Ok(format!("{version}, {}", glslang.path().display()))
    });
    let dawn = machine.dawn();
    let package = dawn.map(|dawn| format!("{}, {}", dawn.version(), dawn.package().display()));
    let node = dawn.map_err(ToString::to_string).and_then(|dawn| {
        let version = dawn.node_version().map_err(|e| e.to_string())?;
        Ok(format!("{version}, {}", dawn.node().display()))
    });
    let on_pages = |package: web::Package| format!("{}, {}", package.version(), package.folder().display());
    let three = web::three().map(on_pages).map_err(|e| e.to_string());
    let godot = web::godot().map(on_pages).map_err(|e| e.to_string());
    let playwright = web::playwright().map(on_pages).map_err(|e| e.to_string());
    let browser = web::browser().map(|path| path.display().to_string());
    let folder = translate::tools_dir().map(|path| path.display().to_string());
    vec![
        Tool { name: "dxc", found: dxc.map_err(ToString::to_string) },
        Tool { name: "slang", found: slang.map_err(ToString::to_string) },
        Tool { name: "glslang", found: glslang },
        Tool {
            name: "spirv-val",
            found: spirv_val::find().map(|p| p.display().to_string()).map_err(|e| e.to_string()),
        },
        Tool { name: "dawn", found: package.map_err(ToString::to_string) },
        Tool { name: "node", found: node },
        Tool { name: "browser", found: browser.map_err(|e| e.to_string()) },
        Tool { name: "playwright", found: playwright },
        Tool { name: "three.js", found: three },
        Tool { name: "Godot", found: godot },
        Tool {
            name: "tools folder",
            found: folder.ok_or_else(|| "there is none; run tests/setup.sh".to_owned()),
        },
    ]
}

fn human(machine: &Machine, tools: &[Tool]) -> String {
    let mut out = "routes\n".to_owned();
    for (route, state) in machine.routes() {
        let _ = match state {
            State::Ready => writeln!(out, "  ok       {route}"),
            State::Missing { what, mend } => writeln!(out, "  missing  {route}: {what}; {mend}"),
        };
    }
    out += "drivers\n";
    for driver in machine.drivers().iter().chain(machine.gl_drivers()) {
        let _ = writeln!(out, "  {:<12} {} ({})", driver.name, driver.adapter_name, driver.driver_info);
    }
    if machine.drivers().is_empty() && machine.gl_drivers().is_empty() {
        out += "  none; `native` and `interp` need none\n";
    }
    out += "tools\n";
    for tool in tools {
        let _ = match &tool.found {
            Ok(what) => writeln!(out, "  ok       {}: {what}", tool.name),
            Err(why) => writeln!(out, "  missing  {}: {why}", tool.name),
        };
    }
    out
}

fn as_json(machine: &Machine, tools: &[Tool]) -> Value {
    let route = |(route, state): (lobe_backends::route::Route, State)| match state {
        State::Ready => json!({ "route": route.to_string(), "ready": true }),
        State::Missing { what, mend } => {
            json!({ "route": route.to_string(), "ready": false, "what": what, "mend": mend })
        }
    };
    let tool = |tool: &Tool| match &tool.found {
        Ok(what) => json!({ "tool": tool.name, "ready": true, "what": what }),
        Err(why) => json!({ "tool": tool.name, "ready": false, "what": why }),
    };
    let driver = |d: &lobe_backends::gpu::Driver| json!({ "driver": d.name, "device": d.adapter_name, "version": d.driver_info, "software": d.is_software });
    json!({
        "schema": 1,
        "routes": machine.routes().into_iter().map(route).collect::<Vec<_>>(),
        "drivers": machine.drivers().iter().chain(machine.gl_drivers()).map(driver).collect::<Vec<_>>(),
        "tools": tools.iter().map(tool).collect::<Vec<_>>(),
    })
}
