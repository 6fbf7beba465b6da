//! What hides virtual lights, by imperfect shadow maps.

use crate::render::Frame;
use lobe_backends::executor::ExecError;
use lobe_kernels::rsm::imperfect::fill::PullStep;
use lobe_kernels::rsm::imperfect::share::ImperfectSettings;
use lobe_kernels::rsm::shade::LightTurn;

/// Points of the set, at most: they take 32 bytes each.
const BLOCKERS: u64 = 1 << 18;
/// Points that a pass splats, at most; drivers take 65,535 workgroups.
const SPLATS: u32 = 1 << 20;
/// Texels of a turn's maps, at most.
const TEXELS: u32 = 1 << 20;
/// Texels along a side of a map, at most.
const SIDE: u32 = 128;

/// The side of a map: a power of 2.
fn side(asked: u32) -> u32 {
    asked.clamp(1, SIDE).next_power_of_two()
}

/// Maps that a turn has room for, at most.
pub(super) fn maps_of_turn(asked: u32) -> u32 {
    TEXELS / side(asked).pow(2)
}

/// The points of all of `lights` together.
fn points(each: u32, lights: u32) -> u32 {
    u64::from(each.max(1)).saturating_mul(lights.into()).min(u32::MAX.into()) as u32
}

impl Frame<'_, '_> {
    /// The set of points on the scene's surfaces.
    pub(super) fn blockers(&mut self) -> Result<(), ExecError> {
        let settings = self.settings.virtual_lights;
        let stride = self.pipeline.layout("triangles")?.stride as usize;
        let triangles = (self.memory.bytes("triangles").len() / stride.max(1)) as u32;
        self.room("estimates", triangles)?;
        self.dispatch("triangle_area_pass", triangles)?;
        self.sums_of_estimates("scan_pass", triangles)?;
        let wanted = u64::from(points(settings.shadow_points, settings.count.max(1)));
        let count = wanted.min(BLOCKERS) as u32;
        self.room("blockers", count)?;
        self.dispatch("blocker_pass", count)
    }

    /// How many points each of `lights` has, by what it sends.
    pub(super) fn point_runs(&mut self, lights: u32) -> Result<(), ExecError> {
        self.room("estimates", lights)?;
        self.dispatch("sent_power_pass", lights)?;
        self.sums_of_estimates("scan_pass", lights)?;
        self.imperfect(lights, 0, 0)?;
        self.room("point_runs", lights + 1)?;
        self.dispatch("point_run_pass", lights + 1)
    }

    fn imperfect(&mut self, lights: u32, first: u32, shift: u32) -> Result<(), ExecError> {
        let settings = self.settings.virtual_lights;
        let imperfect = ImperfectSettings {
            points: points(settings.shadow_points, lights),
            floor_share: settings.shadow_floor,
            side: side(settings.shadow_map),
            first,
            shift,
        };
        self.memory.put("imperfect", self.pipeline.pack("imperfect", &[imperfect])?);
        Ok(())
    }

    /// The maps of a turn of `lights`, whose runs begin at `shift` of the set, and what of its pixels they see.
    pub(super) fn imperfect_shadows(
        &mut self,
        turn: LightTurn,
        lights: u32,
        shift: u32,
    ) -> Result<(), ExecError> {
        let side = side(self.settings.virtual_lights.shadow_map);
        let texels = side * side * turn.count + means(&pull_steps(side, turn.count));
        self.room("codes", texels)?;
        self.room("owners", texels)?;
        let runs: Vec<u32> = self.pipeline.unpack("point_runs", self.memory.bytes("point_runs"))?;
        let begin = |light: u32| runs.get(light as usize).copied().unwrap_or(0);
        let (first, end) = (begin(turn.first), begin(turn.first + turn.count));
        // All depths are to be there before a point is known for the nearest.
        for pass in ["splat_nearest_pass", "splat_owner_pass"] {
            for first in (first..end).step_by(SPLATS as usize) {
                let count = SPLATS.min(end - first);
                self.imperfect(lights, first, shift)?;
                self.room("splats", count)?;
                self.dispatch("splat_pass", count)?;
                self.dispatch(pass, count)?;
            }
        }
        self.imperfect(lights, first, shift)?;
        self.fill_holes(side, turn.count)?;
        let pixels = self.pixels() * turn.count;
        self.room("visible", pixels)?;
        self.dispatch("imperfect_shadow_pass", pixels)
    }

    /// Depths of all texels of `maps` maps.
    fn fill_holes(&mut self, side: u32, maps: u32) -> Result<(), ExecError> {
        let levels = pull_steps(side, maps);
        self.room("hole_depths", means(&levels).max(1))?;
        for (level, step) in levels.iter().enumerate() {
            self.memory.put("pull_step", self.pipeline.pack("pull_step", &[*step])?);
            self.dispatch(if level == 0 { "pull_first_pass" } else { "pull_pass" }, step.count)?;
        }
        self.room("map_depths", side * side * maps)?;
        self.dispatch("hole_fill_pass", side * side * maps)
    }
}

/// The levels of means of `maps` maps, until each has one.
fn pull_steps(side: u32, maps: u32) -> Vec<PullStep> {
    let texels = side * side * maps;
    let (mut below, mut first, mut side) = (0, texels, side);
    let mut steps = Vec::new();
    while side > 1 {
        side /= 2;
        let count = side * side * maps;
        steps.push(PullStep { side, count, first, below, texels });
        (below, first) = (first, first + count);
    }
    steps
}

/// How many means the levels have.
fn means(steps: &[PullStep]) -> u32 {
    steps.iter().map(|step| step.count).sum()
}
