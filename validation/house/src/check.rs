//! The house against its declared order.
//!
//! Limits: what is not declared is not checked, except for circles of files and packages without a line in the order.

use crate::{
    finding::Finding,
    house::{House, is_root},
};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

impl House {
    /// All that breaks the order; empty where the house is as declared.
    pub fn findings(&self) -> Vec<Finding> {
        let mut findings = self.dependencies();
        for package in 0..self.packages.len() {
            findings.extend(self.unknown_rooms(package));
            let upward = self.upward(package).into_iter();
            findings.extend(upward.map(|(a, from, to)| Finding::Upward { arrow: a.clone(), from: from.into(), to: to.into() }));
        }
        findings.extend(self.circle_findings());
        findings.extend(self.said.iter().map(Finding::from));
        findings
    }

    fn circle_findings(&self) -> Vec<Finding> {
        let allowed: BTreeSet<&BTreeSet<String>> = self.order.circles.iter().map(|c| &c.files).collect();
        let mut there = BTreeSet::new();
        let mut findings = Vec::new();
        for package in 0..self.packages.len() {
            for files in self.circles(package) {
                if !allowed.contains(&files) {
                    let within = self.arrows[package].iter().filter(|a| files.contains(&a.from) && files.contains(&a.to));
                    findings.push(Finding::Circle { arrows: within.cloned().collect(), files: files.clone() });
                }
                there.insert(files);
            }
        }
        let gone = self.order.circles.iter().filter(|c| !there.contains(&c.files));
        findings.extend(gone.map(|c| Finding::NoCircle { files: c.files.clone(), reason: c.reason.clone() }));
        findings
    }

    fn unknown_rooms(&self, package: usize) -> Vec<Finding> {
        let name = &self.packages[package].name;
        if !self.order.rooms.contains_key(name) {
            return Vec::new();
        }
        let rooms = self.files_by_room(package).into_iter();
        let unknown = rooms.filter(|(room, _)| !is_root(room) && self.order.storey(name, room).is_none());
        let finding =
            |room: &str, file: &str| Finding::UnknownRoom { package: name.clone(), room: room.into(), file: file.into() };
        unknown.map(|(room, files)| finding(room, files[0])).collect()
    }

    fn dependencies(&self) -> Vec<Finding> {
        let known: BTreeSet<&str> = self.packages.iter().map(|p| p.name.as_str()).collect();
        let mut findings = Vec::new();
        for package in &self.packages {
            let Some(declared) = self.order.crates.get(&package.name) else {
                findings.push(Finding::UnknownPackage { package: package.name.clone() });
                continue;
            };
            let inside = package.depends_on.iter().filter(|on| known.contains(on.as_str()));
            findings.extend(inside.filter(|on| !declared.may_depend_on.contains(*on)).map(|on| Finding::Dependency {
                package: package.name.clone(),
                folder: package.folder.clone(),
                on: on.clone(),
            }));
            let ways = declared.must_not_know.iter().filter_map(|other| self.way(&package.name, other));
            findings.extend(ways.map(|way| Finding::MustNotKnow { way, because: declared.because.clone() }));
        }
        findings
    }

    /// The shortest way of dependencies from one package to another.
    fn way(&self, from: &str, to: &str) -> Option<Vec<String>> {
        let on: BTreeMap<&str, &BTreeSet<String>> = self.packages.iter().map(|p| (p.name.as_str(), &p.depends_on)).collect();
        let mut open = VecDeque::from([vec![from.to_owned()]]);
        let mut seen = BTreeSet::new();
        while let Some(way) = open.pop_front() {
            let last = way.last()?;
            if last == to {
                return Some(way);
            }
            for next in on.get(last.as_str()).into_iter().flat_map(|names| names.iter()) {
                if seen.insert(next.clone()) {
                    open.push_back(way.iter().chain([next]).cloned().collect());
                }
            }
        }
        None
    }
}
