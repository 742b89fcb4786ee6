//! Which first turns occur on a grid, how often, and where for example.

use std::collections::HashMap;

use littlewood::tables::{PhaseSequence, Setup};
use littlewood::{Hoop, ParameterError};
use littlewood_sweep::Grid;
use rayon::prelude::*;

use crate::first_turn::{FirstTurn, Stop};

/// What tells first turns apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Kind {
    /// Those with more phases than fit are told apart by the phases that fit.
    pub(crate) sequence: PhaseSequence,
    pub(crate) stop: Stop,
}

/// A kind of first turn that occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Entry {
    pub(crate) kind: Kind,
    /// Number of points of the grids that have it.
    pub(crate) count: u64,
    /// The first of them.
    pub(crate) example: Setup,
    /// The number of that point; the points of later grids are numbered after those of earlier ones.
    number: u64,
}

/// All kinds of first turns on one or more grids, the most frequent first.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Atlas {
    pub(crate) entries: Vec<Entry>,
    /// Points of the grids.
    pub(crate) points: u64,
}

impl Atlas {
    /// First turns with μs = μk: μk is that of μs, whatever the grid says.
    ///
    /// # Errors
    /// A value without physical meaning.
    pub(crate) fn of_first_turns(grid: &Grid) -> Result<Self, ParameterError> {
        let kinds: Vec<Result<Kind, ParameterError>> = (0..grid.len())
            .into_par_iter()
            .map(|number| kind(&with_one_friction(grid.point(number))))
            .collect();
        let mut atlas = Self {
            entries: Vec::new(),
            points: grid.len(),
        };
        // Where each kind stands in the list.
        let mut places: HashMap<Kind, usize> = HashMap::new();
        for (number, kind) in (0..).zip(kinds) {
            let kind = kind?;
            let place = *places.entry(kind).or_insert(atlas.entries.len());
            if let Some(known) = atlas.entries.get_mut(place) {
                known.count += 1;
            } else {
                atlas.entries.push(Entry {
                    kind,
                    count: 1,
                    example: with_one_friction(grid.point(number)),
                    number,
                });
            }
        }
        atlas.sort();
        Ok(atlas)
    }

    pub(crate) fn has(&self, kind: Kind) -> bool {
        self.entries.iter().any(|entry| entry.kind == kind)
    }

    /// Adds the atlas of another grid, whose points are numbered after those that are there.
    pub(crate) fn absorb(&mut self, other: Self) {
        let before = self.points;
        for entry in other.entries {
            match self
                .entries
                .iter_mut()
                .find(|known| known.kind == entry.kind)
            {
                Some(known) => known.count += entry.count,
                None => self.entries.push(Entry {
                    number: before + entry.number,
                    ..entry
                }),
            }
        }
        self.points += other.points;
        self.sort();
    }

    fn sort(&mut self) {
        self.entries
            .sort_by_key(|entry| (core::cmp::Reverse(entry.count), entry.number));
    }
}

fn kind(point: &Setup) -> Result<Kind, ParameterError> {
    let turn = FirstTurn::new(&Hoop::new(point.hoop)?, point.start)?;
    Ok(Kind {
        sequence: turn.sequence,
        stop: turn.stop,
    })
}

fn with_one_friction(mut point: Setup) -> Setup {
    point.hoop.mu_k = point.hoop.mu_s;
    point
}

#[cfg(test)]
mod tests {
    use littlewood::tables::{Quantity, Setup};
    use littlewood::{Hoop, HoopParameters, Start};
    use littlewood_sweep::{Axis, Grid};

    use super::Atlas;
    use crate::first_turn::FirstTurn;

    /// 1,728 starts in the set-up of Theron and Maritz, with a particle at distances up to a limit.
    fn grid(least_offset: f64, offsets: usize) -> Grid {
        // μk of the grid is not used.
        let hoop = HoopParameters::thin(1.0 / 3.0).with_friction(0.5, 0.0);
        let axis = |quantity, from, to, count| Axis::new(quantity, from, to, count).unwrap();
        let axes = vec![
            axis(Quantity::Offset, least_offset, 1.0, offsets),
            axis(Quantity::MuS, 0.02, 0.5, 12),
            axis(Quantity::ThetaRate, 0.05, 1.9, 12),
        ];
        Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), axes).unwrap()
    }

    #[test]
    fn the_set_up_of_theron_and_maritz_has_dozens_of_sequences() {
        let grid = grid(0.05, 12);
        let atlas = Atlas::of_first_turns(&grid).unwrap();
        let total: u64 = atlas.entries.iter().map(|entry| entry.count).sum();
        assert_eq!((atlas.points, total), (1728, 1728));
        for entry in &atlas.entries {
            assert_eq!(entry.example.hoop.mu_s, entry.example.hoop.mu_k);
            assert_eq!(
                grid.point(entry.number).start.theta_rate,
                entry.example.start.theta_rate
            );
            let hoop = Hoop::new(entry.example.hoop).unwrap();
            let turn = FirstTurn::new(&hoop, entry.example.start).unwrap();
            assert_eq!(
                (turn.sequence, turn.stop),
                (entry.kind.sequence, entry.kind.stop)
            );
            // From the top nothing but rolling or flight can begin, and with one friction rolling
            // gives way to sliding.
            let text = entry.kind.sequence.to_string();
            assert!(text == "F" || text.starts_with('R'), "{text}");
            assert!(!text.contains("RR") && !text.contains("RF"), "{text}");
        }
        assert!(atlas.entries.len() > 15, "{}", atlas.entries.len());
        assert!(
            atlas
                .entries
                .windows(2)
                .all(|pair| pair[0].count >= pair[1].count)
        );
    }

    #[test]
    fn an_atlas_of_two_grids_counts_the_points_of_both() {
        let mut both = Atlas::of_first_turns(&grid(0.05, 2)).unwrap();
        let parts = [both.clone(), Atlas::of_first_turns(&grid(0.6, 3)).unwrap()];
        both.absorb(parts[1].clone());
        assert_eq!(both.points, parts[0].points + parts[1].points);
        for entry in &both.entries {
            let known = |part: &Atlas| {
                part.entries
                    .iter()
                    .find(|known| known.kind == entry.kind)
                    .copied()
            };
            let [first, second] = [known(&parts[0]), known(&parts[1])];
            let count = |found: Option<super::Entry>| found.map_or(0, |found| found.count);
            assert_eq!(entry.count, count(first) + count(second));
            assert_eq!(Some(entry.example), first.or(second).map(|it| it.example));
        }
    }
}
