//! Decisions, carried out.

use super::error::StoreError;
use super::read::standing;
use super::{Found, IMAGES, MOST_BYTES, PENDING, Reviewer, Store, files_of, put, remove, undo_files};
use crate::decision::{Action, Decision, Step};
use crate::name::CaseName;
use crate::record::Acceptance;
use crate::transaction::Change;
use std::path::PathBuf;

/// What decisions come to.
#[derive(Default)]
struct Plan {
    changes: Vec<Change>,
    lines: Vec<Decision>,
}

impl Store {
    /// Carries out decisions on pending goldens, all or none.
    ///
    /// # Errors
    /// When one cannot be carried out; then none was.
    pub fn carry_out(&self, steps: &[Step], reviewer: &Reviewer) -> Result<Vec<Decision>, StoreError> {
        let _lock = self.writing()?;
        let mut plan = Plan::default();
        for (at, step) in steps.iter().enumerate() {
            if steps[..at].iter().any(|before| before.case == step.case) {
                return Err(StoreError::Twice { case: step.case.clone() });
            }
            self.plan(step, reviewer, &mut plan)?;
        }
        self.check_room(&plan)?;
        plan.changes.push(self.logged(&plan.lines)?);
        self.commit(plan.changes)?;
        Ok(plan.lines)
    }

    fn plan(&self, step: &Step, reviewer: &Reviewer, plan: &mut Plan) -> Result<(), StoreError> {
        let case = &step.case;
        if step.reason.trim().is_empty() {
            return Err(StoreError::NoReason { case: case.clone() });
        }
        let pending = self.found(files_of(PENDING, case), case)?;
        let pending = pending.ok_or_else(|| StoreError::NotPending { case: case.clone() })?;
        let record = &pending.record;
        for (seen, found) in [(&step.chain, &record.chain.hash), (&step.exr, &record.exr)] {
            if let Some(seen) = seen.as_ref().filter(|seen| *seen != found) {
                let (seen, found) = (seen.clone(), found.clone());
                return Err(StoreError::Moved { case: case.clone(), seen, found });
            }
        }
        // One that cannot be used is replaced, and lost but for git.
        let before = self.found(files_of(IMAGES, case), case).ok().flatten();
        let mut line = line(reviewer, Action::Reject, case, &step.reason);
        (line.chain, line.exr) = (Some(record.chain.hash.clone()), Some(record.exr.clone()));
        if step.accepts {
            line.action = Action::Accept;
            line.replaced = before.as_ref().map(|found| found.record.exr.clone());
            if let Some(before) = &before {
                plan.changes.extend(self.kept(files_of(IMAGES, case), before)?);
            }
            let mut record = record.clone();
            let Reviewer { by, at } = reviewer.clone();
            record.accepted = Some(Acceptance { by, at, why: step.reason.clone() });
            let [exr, toml] = files_of(IMAGES, case);
            plan.changes.push(put(exr, self.read(&files_of(PENDING, case)[0])?));
            plan.changes.push(put(toml, self.toml(&record)?));
        } else {
            plan.changes.extend(self.kept(files_of(PENDING, case), &pending)?);
        }
        plan.changes.extend(files_of(PENDING, case).map(remove));
        plan.lines.push(line);
        Ok(())
    }

    /// Keeps a golden for those who take a decision back.
    fn kept(&self, from: [PathBuf; 2], found: &Found) -> Result<[Change; 2], StoreError> {
        let [exr, toml] = undo_files(&found.record.case, &found.record.exr);
        Ok([put(exr, self.read(&from[0])?), put(toml, self.read(&from[1])?)])
    }

    fn read(&self, path: &PathBuf) -> Result<Vec<u8>, StoreError> {
        let path = self.root.join(path);
        std::fs::read(&path).map_err(|cause| StoreError::Io { path, cause })
    }

    /// Whether all goldens still have room.
    fn check_room(&self, plan: &Plan) -> Result<(), StoreError> {
        let new = plan.changes.iter().filter(|change| change.path.starts_with(IMAGES));
        let room = |path: &PathBuf| std::fs::metadata(self.root.join(path)).map_or(0, |file| file.len());
        let (mut more, mut less) = (0, 0);
        for change in new {
            more += change.bytes.as_ref().map_or(0, |bytes| bytes.len() as u64);
            less += room(&change.path);
        }
        let all: u64 = self.all_files()?.iter().map(room).sum();
        let bytes = (all + more).saturating_sub(less);
        if bytes > MOST_BYTES { Err(StoreError::Full { bytes }) } else { Ok(()) }
    }

    fn all_files(&self) -> Result<Vec<PathBuf>, StoreError> {
        Ok(self.cases(IMAGES)?.iter().flat_map(|case| files_of(IMAGES, case)).collect())
    }

    /// Removes goldens, usable or not.
    ///
    /// # Errors
    /// When files cannot be moved; then none was.
    pub fn prune(
        &self,
        cases: &[CaseName],
        reviewer: &Reviewer,
        reason: &str,
    ) -> Result<Vec<Decision>, StoreError> {
        let _lock = self.writing()?;
        let mut plan = Plan::default();
        for case in cases {
            let mut line = line(reviewer, Action::Prune, case, reason);
            if let Ok(Some(found)) = self.found(files_of(IMAGES, case), case) {
                line.exr = Some(found.record.exr.clone());
                line.chain = Some(found.record.chain.hash.clone());
                plan.changes.extend(self.kept(files_of(IMAGES, case), &found)?);
            }
            plan.changes.extend(files_of(IMAGES, case).map(remove));
            plan.lines.push(line);
        }
        plan.changes.push(self.logged(&plan.lines)?);
        self.commit(plan.changes)?;
        Ok(plan.lines)
    }

    /// Takes the last decision back that nobody took back: an accepted golden waits again, and the one before it is accepted
    /// again; a rejected one waits again; a pruned one is accepted again.
    ///
    /// # Errors
    /// When there is none, or what it replaced is not on this machine.
    pub fn undo(&self, reviewer: &Reviewer, reason: &str) -> Result<Decision, StoreError> {
        let _lock = self.writing()?;
        let last = standing(self.log()?).pop().ok_or(StoreError::NothingToUndo)?;
        let case = &last.case;
        let mut changes = match last.action {
            Action::Accept => self.unaccepted(&last)?,
            Action::Reject => self.restored(&last, PENDING)?,
            Action::Prune | Action::Undo => self.restored(&last, IMAGES)?,
        };
        let mut line = line(reviewer, Action::Undo, case, reason);
        (line.chain, line.exr, line.replaced) = (last.chain.clone(), last.replaced.clone(), last.exr.clone());
        changes.push(self.logged(std::slice::from_ref(&line))?);
        self.commit(changes)?;
        Ok(line)
    }

    fn unaccepted(&self, last: &Decision) -> Result<Vec<Change>, StoreError> {
        let case = &last.case;
        let now = self.found(files_of(IMAGES, case), case)?;
        let forgotten =
            || StoreError::Forgotten { case: case.clone(), path: self.root.join(&files_of(IMAGES, case)[0]) };
        let now = now.filter(|now| Some(&now.record.exr) == last.exr.as_ref()).ok_or_else(forgotten)?;
        let mut record = now.record.clone();
        record.accepted = None;
        let [exr, toml] = files_of(PENDING, case);
        let mut changes =
            vec![put(exr, self.read(&files_of(IMAGES, case)[0])?), put(toml, self.toml(&record)?)];
        match &last.replaced {
            Some(before) => {
                let before = Decision { exr: Some(before.clone()), ..last.clone() };
                changes.extend(self.restored(&before, IMAGES)?);
            }
            None => changes.extend(files_of(IMAGES, case).map(remove)),
        }
        Ok(changes)
    }

    /// What was kept of a golden goes to `folder` again.
    fn restored(&self, of: &Decision, folder: &str) -> Result<Vec<Change>, StoreError> {
        let Some(exr) = &of.exr else { return Ok(Vec::new()) };
        let kept = undo_files(&of.case, exr);
        let is_there = self.found(kept.clone(), &of.case)?.is_some();
        if !is_there {
            return Err(StoreError::Forgotten { case: of.case.clone(), path: self.root.join(&kept[0]) });
        }
        let both = files_of(folder, &of.case).into_iter().zip(kept);
        both.map(|(to, from)| Ok(put(to, self.read(&from)?))).collect()
    }
}

fn line(reviewer: &Reviewer, action: Action, case: &CaseName, reason: &str) -> Decision {
    let Reviewer { by, at } = reviewer.clone();
    let reason = reason.to_owned();
    Decision { at, by, action, case: case.clone(), reason, chain: None, exr: None, replaced: None }
}
