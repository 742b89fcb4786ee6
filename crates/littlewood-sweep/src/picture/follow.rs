//! The boundaries between the colours of a map, followed between the points of its grid.

use littlewood::Hoop;
use littlewood::tables::{Class, Setup};

use super::cells::of_class;
use super::map::Picture;
use super::shade::Shade;
use crate::axis::Axis;
use crate::columns::Columns;
use crate::compute::{Halt, Points, Workers};
use crate::error::SweepError;
use crate::options::Options;
use crate::regions::{Place, Regions};
use crate::watch::Ledger;

/// How closely boundaries are located, in parts of the map: for pixels to less than one, for vectors
/// as closely as can be seen at any size.
const PIXELS: f64 = 5e-4;
const VECTORS: f64 = 1e-6;

/// Motions that are followed to locate the boundaries of any map. Those of a larger one may take as
/// many as it has points.
const MOTIONS: usize = 20_000;

/// Follows motions between the points of a grid.
struct Follower<'a> {
    picture: &'a Picture,
    workers: &'a Workers,
    ledger: &'a Ledger<'a>,
    is_one_hoop: bool,
    /// Motions that may still be followed.
    left: usize,
}

impl Picture {
    /// Follows the boundaries between colours as curves: between neighbours of the grid that
    /// differ, motions are computed, as many as the grid has points at most. The result does not
    /// depend on the number of threads. Cancelled, it returns false and leaves the picture as it
    /// is, and so it does where not every point has been added.
    ///
    /// # Errors
    /// As [`Workers::compute`].
    pub fn follow(&mut self, workers: &Workers, options: &Options<'_>) -> Result<bool, SweepError> {
        if self.counts.iter().any(|count| *count < 2) || !self.is_complete() {
            return Ok(true);
        }
        // Nobody knows how many starts it takes.
        let ledger = Ledger::new(options, 0, 0);
        let mut follower = Follower {
            picture: self,
            workers,
            ledger: &ledger,
            is_one_hoop: !self.grid.axes().iter().any(Axis::is_of_the_hoop),
            left: self.cells.len().max(MOTIONS),
        };
        let width = if self.is_in_vectors { VECTORS } else { PIXELS };
        match Regions::find(&self.lattice(), width, &mut |places| follower.keys(places)) {
            Ok(regions) => {
                self.regions = regions;
                Ok(true)
            }
            Err(Halt::Cancelled) => Ok(false),
            Err(Halt::Refused(refused)) => Err(refused.error.into()),
        }
    }
}

impl Follower<'_> {
    fn keys(&mut self, places: &[Place]) -> Result<Option<Vec<u64>>, Halt> {
        let Some(left) = self.left.checked_sub(places.len()) else {
            return Ok(None);
        };
        self.left = left;
        self.follow(places).map(Some)
    }

    /// Follows motions as far as their colours ask for.
    fn follow(&self, places: &[Place]) -> Result<Vec<u64>, Halt> {
        let picture = self.picture;
        let whole: Vec<Setup> = places
            .iter()
            .map(|&place| picture.grid.point_between(place))
            .collect();
        if picture.shade == Shade::Sequence {
            let found = self.compute(&whole)?;
            let rows = found.summaries().zip(found.classes());
            return Ok(rows
                .map(|(summary, class)| picture.key_of(picture.key_at(summary.sequence, *class)))
                .collect());
        }
        let points: Vec<Setup> = whole.iter().map(|point| until_landing(*point)).collect();
        let mut classes = self.compute(&points)?.classes().to_vec();
        // Of what comes before a lift-off only a jam goes on by the law of restitution.
        let jams: Vec<usize> = (0..points.len())
            .filter(|&i| classes[i] == Class::Painleve && points[i] != whole[i])
            .collect();
        if !jams.is_empty() {
            let again: Vec<Setup> = jams.iter().map(|&i| whole[i]).collect();
            let found = self.compute(&again)?;
            for (&i, &class) in jams.iter().zip(found.classes()) {
                classes[i] = class;
            }
        }
        Ok(classes.into_iter().map(of_class).collect())
    }

    fn compute(&self, points: &[Setup]) -> Result<Columns, Halt> {
        let Picture { grid, limits, .. } = self.picture;
        let starts = if self.is_one_hoop {
            u64::MAX
        } else {
            grid.starts_of_a_hoop()
        };
        let watch = self.ledger.watch();
        let points_of_hoop = Points {
            count: points.len(),
            at: &|index| points[index],
            share_hoop: self.is_one_hoop,
            derivatives: &[],
        };
        self.workers
            .follow_points(points_of_hoop, Some(starts), *limits, &watch)
    }
}

/// The same start of a hoop that stays where it lands, which is enough for a class. A hoop that
/// contradicts itself stays as it is.
fn until_landing(point: Setup) -> Setup {
    let mut short = point;
    (short.hoop.restitution, short.hoop.restitution_law) = (None, None);
    if Hoop::new(point.hoop).is_ok() {
        short
    } else {
        point
    }
}
