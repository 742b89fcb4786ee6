//! A map as areas, curves and words, for those who draw it in vectors.

use littlewood::Limits;
use littlewood::tables::PhaseSequence;
use littlewood_style::ticks::Tick;
use littlewood_style::{Curve, RANKS, Rgb, Theme, of_class, of_rank};

use super::cells::{Cell, class_of, place};
use super::frame::{FINE, reduce};
use super::layout::{self, Layout, Sign};
use super::map::Picture;
use super::names::{along, axis_name, is_flipped, ticks_of, unit_of};
use super::pen::clipped;
use super::scale::{Kind, Scale};
use super::shade::Shade;
use crate::compute::{Halt, Workers};
use crate::error::SweepError;
use crate::options::Options;
use crate::regions::{Detail, Lattice, Place, Regions};
use crate::watch::Ledger;

/// A map as areas, curves and words. Places are fractions of the way to the right and upwards; texts have no marks.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// What the map shows, with its unit in parentheses.
    pub title: String,
    /// Whether units are those of SI.
    pub is_si: bool,
    /// What is fixed, and what letters mean.
    pub notes: Vec<String>,
    /// The sign of each axis with its unit in parentheses, and its ticks.
    pub axes: [(String, Vec<Tick>); 2],
    /// What colours and lines mean, with the share of the points of the grid.
    pub legend: Vec<Entry>,
    /// The areas of one colour each; none where the colours are a scale.
    pub areas: Vec<Area>,
    /// The boundaries between areas, or between classes.
    pub boundaries: Vec<Vec<Place>>,
    /// The curves of the phase plane.
    pub curves: Vec<(Curve, Vec<Place>)>,
    /// Lines of constant value.
    pub contours: Vec<[Place; 2]>,
    /// The map itself where it has no areas: numbers on a scale, or one value on an axis.
    pub image: Option<Image>,
    /// The scale of the colours of an image: evenly spaced colours, and ticks.
    pub scale: Option<(Vec<Rgb>, Vec<Tick>)>,
}

/// An entry of the legend.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The colour, if it is an area.
    pub colour: Option<Rgb>,
    /// The curve, if it is one.
    pub curve: Option<Curve>,
    /// What it means.
    pub label: String,
    /// The share of the points.
    pub share: String,
}

/// All places of one colour.
#[derive(Clone, Debug)]
pub struct Area {
    /// The class or the sequence.
    pub name: String,
    /// The colour.
    pub colour: Rgb,
    /// The curves around it, those around holes in the other direction.
    pub outlines: Vec<Vec<Place>>,
}

/// Pixels row by row from the top, three bytes each.
#[derive(Clone, Debug)]
pub struct Image {
    /// Width and height.
    pub size: [usize; 2],
    /// The pixels.
    pub pixels: Vec<u8>,
}

/// Above all sequences that fit, and below the classes.
const OTHERS: u64 = u64::MAX - 0x1ff;

/// Cells of the lattice in which boundaries are followed, at least, and parts of a cell of the grid at most.
const CELLS: usize = 480;
const PARTS: usize = 64;

/// Colours of a continuous scale.
const COLOURS: usize = 128;

impl Picture {
    /// The map in vectors. Boundaries between colours are followed as curves: between neighbours of the grid that differ, motions
    /// are computed. The result does not depend on the number of threads. Cancelled, it returns nothing.
    ///
    /// # Errors
    /// As [`Workers::compute`].
    pub fn drawing(
        &self,
        limits: Limits,
        workers: &Workers,
        options: &Options<'_>,
    ) -> Result<Option<Drawing>, SweepError> {
        let layout = Layout::new(self);
        let units = self.units.as_ref();
        let axes = [0, 1].map(|k| {
            let axis = &self.grid.axes()[k];
            let ticks = ticks_of(axis, units, 10).into_iter();
            let ticks = ticks.map(|tick| Tick { value: along(axis, tick.value), label: tick.label });
            (axis_name(axis, units), ticks.collect())
        });
        let is_plane = self.counts.iter().all(|count| *count > 1) && self.is_complete();
        let found = if is_plane {
            match self.regions(limits, workers, options)? {
                Some(found) => found,
                None => return Ok(None),
            }
        } else {
            Regions { regions: Vec::new(), boundaries: Vec::new() }
        };
        let is_scale = self.shade.is_on_a_scale();
        let areas: Vec<Area> = found
            .regions
            .into_iter()
            .filter(|_| !is_scale)
            .map(|region| Area {
                name: self.name_of(region.key),
                colour: self.colour_of(region.key),
                outlines: region.outlines.into_iter().map(|line| self.upright(line)).collect(),
            })
            .collect();
        let boundaries = found.boundaries.into_iter().map(|boundary| self.upright(boundary.points)).collect();
        let contours = layout.scale.as_ref().map_or_else(Vec::new, |scale| self.contours(scale));
        Ok(Some(Drawing {
            title: layout.title.clone(),
            is_si: units.is_some(),
            notes: self.notes(),
            axes,
            legend: layout.entries.iter().map(Entry::from).collect(),
            image: areas.is_empty().then(|| self.image(&layout)),
            areas,
            boundaries,
            curves: self.clipped_curves(),
            contours,
            scale: layout.scale.map(|scale| self.bar(&scale)),
        }))
    }

    fn regions(
        &self,
        limits: Limits,
        workers: &Workers,
        options: &Options<'_>,
    ) -> Result<Option<Regions>, SweepError> {
        let places = [0, 1].map(|k| {
            let count = self.grid.axes()[k].count();
            let places = (0..self.counts[k]).map(|j| place(j, count, self.counts[k]));
            places.map(|i| i as f64 / (count - 1) as f64).collect()
        });
        let keys = self.cells.iter().map(|cell| self.key_of(*cell)).collect();
        let wanted = self.counts.iter().map(|count| CELLS.div_ceil(count - 1)).max().unwrap_or(1);
        let detail = Detail { parts: wanted.next_power_of_two().min(PARTS), ..Detail::default() };
        let quiet = Options { cancel: options.cancel, ..Options::default() };
        let ledger = Ledger::new(&quiet, 0, 0);
        let mut ask = |places: &[Place]| -> Result<Vec<u64>, Halt> {
            let points: Vec<_> = places.iter().map(|&place| self.grid.point_between(place)).collect();
            let starts = Some(self.grid.starts_of_a_hoop());
            let found = workers.compute_points(&points, starts, limits, &ledger.watch())?;
            let rows = points.iter().zip(found.summaries().zip(found.classes()));
            Ok(rows
                .map(|(point, (summary, class))| self.key_of(self.cell_of(point, &summary, *class)))
                .collect())
        };
        match Regions::find(&Lattice { places, keys }, &detail, &mut ask) {
            Ok(found) => Ok(Some(found)),
            Err(Halt::Cancelled) => Ok(None),
            Err(Halt::Refused(refused)) => Err(refused.error.into()),
        }
    }

    /// What cells of one colour have in common.
    fn key_of(&self, cell: Cell) -> u64 {
        let is_other =
            self.shade == Shade::Sequence && cell.class().is_none() && self.rank(cell.key) >= RANKS;
        if is_other { OTHERS } else { cell.key }
    }

    fn name_of(&self, key: u64) -> String {
        match class_of(key) {
            Some(class) => class.name().to_owned(),
            None if key == OTHERS => "others".to_owned(),
            None => PhaseSequence::from_bits(key).to_string(),
        }
    }

    fn colour_of(&self, key: u64) -> Rgb {
        class_of(key)
            .map_or_else(|| of_rank(self.rank(key), Theme::Light), |class| of_class(class, Theme::Light))
    }

    /// Places with the larger values of the axes to the right and above.
    fn upright(&self, places: Vec<Place>) -> Vec<Place> {
        let flipped = [0, 1].map(|k| is_flipped(&self.grid.axes()[k]));
        let turned = |place: Place| [0, 1].map(|k| if flipped[k] { 1.0 - place[k] } else { place[k] });
        places.into_iter().map(turned).collect()
    }

    /// What is fixed, and the letters of sequences.
    fn notes(&self) -> Vec<String> {
        let meanings = if self.shade == Shade::Sequence { self.meanings() } else { Vec::new() };
        self.fixed().into_iter().chain(meanings).collect()
    }

    /// The map alone, of the picture that it would be.
    fn image(&self, layout: &Layout) -> Image {
        let size = self.size.enlarged(FINE);
        let mut pixels = vec![0xff; size.width as usize * size.height as usize * 3];
        self.paint(&mut pixels, size, layout);
        let (reduced, fine) = (reduce(&pixels, self.size), FINE as i32);
        let frame = layout.frame;
        let [left, right, top, bottom] = [frame.left, frame.right(), frame.top, frame.bottom()]
            .map(|edge| usize::try_from(edge / fine).unwrap_or_default());
        let stride = 3 * self.size.width as usize;
        // Pixels on the edge are mixed with what is around the map.
        let rows = top + 1..bottom;
        let pixels: Vec<u8> = rows
            .clone()
            .flat_map(|row| &reduced[row * stride + 3 * (left + 1)..row * stride + 3 * right])
            .copied()
            .collect();
        Image { size: [right - left - 1, rows.len()], pixels }
    }

    fn clipped_curves(&self) -> Vec<(Curve, Vec<Place>)> {
        if !self.has_curves {
            return Vec::new();
        }
        let curves = self.curves().into_iter();
        curves.flat_map(|(curve, line)| clipped(&line).into_iter().map(move |run| (curve, run))).collect()
    }

    fn bar(&self, scale: &Scale) -> (Vec<Rgb>, Vec<Tick>) {
        let count = match scale.kind {
            Kind::Counts => libm::round(scale.high - scale.low) as usize,
            Kind::Linear | Kind::Log => COLOURS,
        };
        let colours = (0..count).map(|i| scale.at((i as f64 + 0.5) / count as f64)).collect();
        let ticks = scale.ticks(unit_of(self.shade, self.units.as_ref()), 10).into_iter();
        let ticks = ticks.map(|tick| Tick { value: scale.fraction(tick.value), label: tick.label });
        (colours, ticks.collect())
    }
}

impl From<&layout::Entry> for Entry {
    fn from(entry: &layout::Entry) -> Self {
        let (colour, curve) = match entry.sign {
            Sign::Fill(colour) => (Some(colour), None),
            Sign::Line(curve) => (None, Some(curve)),
            Sign::None => (None, None),
        };
        Self { colour, curve, label: entry.label.clone(), share: entry.share.clone() }
    }
}
