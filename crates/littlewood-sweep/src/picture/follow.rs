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
use crate::regions::{Detail, Lattice, Place, Regions};
use crate::watch::Ledger;

/// How closely boundaries are followed.
struct Fineness {
    /// Cells in which they are followed, across the map: where they are closer, corners are cut.
    cells: usize,
    /// How closely each is located, in parts of the map.
    width: f64,
    /// How often a cell is halved in which they meet.
    halvings: u32,
    /// Motions that are followed for each cell across the map; twice as many as usual, for those
    /// along boundaries take longer than others.
    motions_of_a_cell: f64,
    /// What all motions may take. A unit is about a microsecond: a transition, or a slide of length
    /// 3 (the length that [`littlewood::Limits::slides`] counts).
    work: f64,
}

/// For pixels: to less than one, which the middle is within half of. Where boundaries meet, cells
/// are not halved much beyond pixels either: motions there may have thousands of phases.
const PIXELS: Fineness = Fineness {
    cells: 240,
    width: 5e-4,
    halvings: 1,
    motions_of_a_cell: 100.0,
    work: 3e6,
};

/// For drawings in vectors: as closely as they can be.
const VECTORS: Fineness = Fineness {
    cells: 480,
    width: 1e-6,
    halvings: 6,
    motions_of_a_cell: 240.0,
    work: 6e6,
};

/// Parts of a cell of the grid, and cells across the map of slow motions, at least.
const MOST_PARTS: usize = 64;
const FEWEST_CELLS: usize = 4;

/// The longest slide that is followed: whole turns of a longer one are skipped.
const LONGEST_SLIDE: f64 = 32.0;

/// Work up to which a motion is short: with tables of its hoop it takes a tenth of that.
const SHORT: f64 = 100.0;
const SHARE_WITH_TABLES: f64 = 0.1;

/// Starts to either side of the lattice by which it is seen how long motions take.
const SURVEYED: usize = 8;

/// Motions that are followed at once, in parts of all that the work allows; and in the survey.
const AT_ONCE: f64 = 0.05;
const AT_ONCE_IN_SURVEY: usize = 16;

/// Follows motions between the points of a grid, until that has taken too long.
struct Follower<'a> {
    picture: &'a Picture,
    workers: &'a Workers,
    ledger: &'a Ledger<'a>,
    usual: Fineness,
    is_one_hoop: bool,
    at_once: usize,
    /// Motions that were followed, and the work that they took.
    motions: usize,
    work: f64,
}

impl Picture {
    /// Follows the boundaries between colours as curves: between neighbours of the grid that
    /// differ, motions are computed. The work is bounded: where motions take long, boundaries are
    /// followed in fewer cells, which the key says. The result does not depend on the number of
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
            usual: if self.is_in_vectors { VECTORS } else { PIXELS },
            is_one_hoop: !self.grid.axes().iter().any(Axis::is_of_the_hoop),
            at_once: AT_ONCE_IN_SURVEY,
            motions: 0,
            work: 0.0,
        };
        match follower.regions() {
            Ok(found) => {
                self.regions = found.regions;
                self.followed_cells = found.is_coarse.then_some(self.regions.cells);
                Ok(true)
            }
            Err(Halt::Cancelled) => Ok(false),
            Err(Halt::Refused(refused)) => Err(refused.error.into()),
        }
    }
}

/// The regions of a map, and whether the work was too much for what is usual.
struct Found {
    regions: Regions,
    is_coarse: bool,
}

impl Follower<'_> {
    fn regions(&mut self) -> Result<Found, Halt> {
        let survey = Lattice::even([SURVEYED; 2], |_| 0).all_places();
        self.keys(&survey)?;
        let usual = &self.usual;
        let motions = usual.work * self.motions as f64 / self.work;
        let allowed = (motions / usual.motions_of_a_cell) as usize;
        self.at_once = (AT_ONCE * motions) as usize + 1;
        let cells = usual.cells.min(allowed.max(FEWEST_CELLS));
        let detail = Detail {
            parts: self.parts(cells),
            width: usual.width,
            halvings: usual.halvings,
            ..Detail::default()
        };
        let lattice = self.picture.lattice();
        let regions = Regions::find(&lattice, &detail, &mut |places| self.keys(places))?;
        let is_coarse = detail.parts < self.parts(self.usual.cells) || self.is_over();
        Ok(Found { regions, is_coarse })
    }

    /// Parts of a cell of the grid, so that there are so many across the map.
    fn parts(&self, cells: usize) -> usize {
        let parts = self.picture.counts.map(|count| cells.div_ceil(count - 1));
        parts[0].max(parts[1]).next_power_of_two().min(MOST_PARTS)
    }

    fn is_over(&self) -> bool {
        self.work > self.usual.work
    }

    fn keys(&mut self, places: &[Place]) -> Result<Option<Vec<u64>>, Halt> {
        let mut keys = Vec::with_capacity(places.len());
        for some in places.chunks(self.at_once) {
            if self.is_over() {
                return Ok(None);
            }
            keys.extend(self.follow(some)?);
        }
        Ok(Some(keys))
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
