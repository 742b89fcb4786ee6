//! The boundaries between the colours of a map, followed between the points of its grid.

use littlewood::tables::{Class, Setup};
use littlewood::{Hoop, Summary};

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

/// What the motions may take that are followed to locate boundaries. A unit is about a microsecond:
/// a transition, or a slide of length 3 (the length that [`littlewood::Limits::slides`] counts).
const WORK: f64 = 3e6;

/// The longest slide that is followed: whole turns of a longer one are skipped.
const LONGEST_SLIDE: f64 = 32.0;

/// Work up to which a motion is short: with tables of its hoop it takes a tenth of that.
const SHORT: f64 = 100.0;
const SHARE_WITH_TABLES: f64 = 0.1;

/// Motions that are followed at once: some to see how long they take, then those of a part of the
/// work.
const FIRST: usize = 16;
const AT_ONCE: f64 = 0.05 * WORK;

/// Follows motions between the points of a grid.
struct Follower<'a> {
    picture: &'a Picture,
    workers: &'a Workers,
    ledger: &'a Ledger<'a>,
    is_one_hoop: bool,
    /// Motions that were followed, and the work that they took.
    motions: usize,
    work: f64,
}

impl Picture {
    /// Follows the boundaries between colours as curves: between neighbours of the grid that
    /// differ, motions are computed. The work is bounded: where motions take long, boundaries are
    /// located less closely, which the key says. The result does not depend on the number of
    /// threads. Cancelled, it returns false and leaves the picture as it is, and so it does where
    /// not every point has been added.
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
            motions: 0,
            work: 0.0,
        };
        let width = if self.is_in_vectors { VECTORS } else { PIXELS };
        let found = Regions::find(&self.lattice(), width, &mut |places| follower.keys(places));
        let is_cut = follower.is_over();
        match found {
            Ok(regions) => {
                (self.regions, self.is_cut) = (regions, is_cut);
                Ok(true)
            }
            Err(Halt::Cancelled) => Ok(false),
            Err(Halt::Refused(refused)) => Err(refused.error.into()),
        }
    }
}

impl Follower<'_> {
    fn keys(&mut self, places: &[Place]) -> Result<Option<Vec<u64>>, Halt> {
        let mut keys = Vec::with_capacity(places.len());
        while keys.len() < places.len() {
            if self.is_over() {
                return Ok(None);
            }
            let count = match self.motions {
                0 => FIRST,
                motions => (AT_ONCE * motions as f64 / self.work) as usize + 1,
            };
            let rest = &places[keys.len()..];
            keys.extend(self.follow(&rest[..count.min(rest.len())])?);
        }
        Ok(Some(keys))
    }

    fn is_over(&self) -> bool {
        self.work > WORK
    }

    /// Follows motions as far as their colours ask for.
    fn follow(&mut self, places: &[Place]) -> Result<Vec<u64>, Halt> {
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

    fn compute(&mut self, points: &[Setup]) -> Result<Columns, Halt> {
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
        let found = self
            .workers
            .follow_points(points_of_hoop, Some(starts), *limits, &watch)?;
        self.motions += points.len();
        self.work += found
            .summaries()
            .zip(points)
            .map(|(summary, point)| self.work_of(&summary, point))
            .sum::<f64>();
        Ok(found)
    }

    /// The work of a motion. What has no number takes none.
    fn work_of(&self, summary: &Summary, point: &Setup) -> f64 {
        let transitions = 1.0 + f64::from(summary.transitions);
        let time = summary.end.time - point.start.time;
        let angle = summary.end.theta - point.start.theta;
        let slides = (LONGEST_SLIDE * transitions).min(time.abs() + angle.abs());
        let work = transitions + slides / 3.0;
        if self.is_one_hoop {
            SHARE_WITH_TABLES * work.min(SHORT) + (work - SHORT).max(0.0)
        } else {
            work
        }
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
