//! How a grid is cut into chunks.

use littlewood::tables::Setup;

use crate::grid::Grid;
use crate::options::MOST_CHUNK_POINTS;

/// The chunks of a grid: equal boxes, those at the far ends cut off.
///
/// The axes of the start fill a chunk first, the last of them fastest, then those of the hoop: so a
/// chunk has as few hoops, and as many starts of each, as its size allows.
///
/// ```
/// use littlewood::tables::{Quantity, Setup};
/// use littlewood::{HoopParameters, Start};
/// use littlewood_sweep::{Axis, Chunks, Grid};
///
/// let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
/// let theta = Axis::new(Quantity::Theta, -1.0, 1.0, 1000)?;
/// let mass_ratio = Axis::new(Quantity::MassRatio, 0.0, 4.0, 700)?;
/// let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 1.0)), vec![theta, mass_ratio])?;
/// let chunks = Chunks::new(&grid, 65_536);
/// assert_eq!(chunks.shape(), [1000, 64]);
/// assert_eq!(chunks.count(), 11);
/// # Ok::<(), littlewood_sweep::AxisError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chunks {
    grid: Vec<usize>,
    shape: Vec<usize>,
}

/// A chunk: a box of points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chunk {
    /// Place of the chunk among the chunks, along each axis.
    pub place: Vec<usize>,
    /// First point, along each axis.
    pub origin: Vec<usize>,
    /// Number of points, along each axis.
    pub shape: Vec<usize>,
}

impl Chunks {
    /// Cuts a grid into chunks of at most `points` points, from 1 to [`MOST_CHUNK_POINTS`].
    #[must_use]
    pub fn new(grid: &Grid, points: usize) -> Self {
        let axes = grid.axes();
        let mut shape = vec![1; axes.len()];
        let mut room = points.clamp(1, MOST_CHUNK_POINTS);
        let order = (0..axes.len())
            .rev()
            .filter(|&i| !axes[i].is_of_the_hoop())
            .chain((0..axes.len()).rev().filter(|&i| axes[i].is_of_the_hoop()));
        for i in order {
            let count = axes[i].count();
            if count <= room {
                shape[i] = count;
                room /= count;
            } else {
                // As few chunks as fit, of even size.
                shape[i] = count.div_ceil(count.div_ceil(room));
                break;
            }
        }
        Self {
            grid: grid.shape(),
            shape,
        }
    }

    /// Chunks of a given shape; sizes that exceed the grid are reduced to it.
    pub(crate) fn of_shape(grid: &Grid, mut shape: Vec<usize>) -> Self {
        let grid = grid.shape();
        shape.resize(grid.len(), 1);
        for (size, &count) in shape.iter_mut().zip(&grid) {
            *size = (*size).clamp(1, count);
        }
        Self { grid, shape }
    }

    /// Shape of a chunk.
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// Number of chunks; `usize::MAX` if there are more.
    pub fn count(&self) -> usize {
        self.places().fold(1, usize::saturating_mul)
    }

    fn places(&self) -> impl DoubleEndedIterator<Item = usize> + '_ {
        self.grid
            .iter()
            .zip(&self.shape)
            .map(|(count, size)| count.div_ceil(*size))
    }

    /// A chunk below [`Chunks::count`]; the last axis runs fastest.
    pub fn chunk(&self, number: usize) -> Chunk {
        let mut rest = number;
        let mut place: Vec<usize> = self
            .places()
            .rev()
            .map(|count| {
                let i = rest % count;
                rest /= count;
                i
            })
            .collect();
        place.reverse();
        let origin: Vec<usize> = place
            .iter()
            .zip(&self.shape)
            .map(|(i, size)| i * size)
            .collect();
        let shape = origin
            .iter()
            .zip(&self.shape)
            .zip(&self.grid)
            .map(|((origin, size), count)| (*size).min(count - origin))
            .collect();
        Chunk {
            place,
            origin,
            shape,
        }
    }
}

impl Chunk {
    /// Number of points.
    pub fn len(&self) -> usize {
        self.shape.iter().product()
    }

    /// Whether there are no points; which no chunk of a grid is.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The places of its points on the axes of the grid; the last axis runs fastest.
    pub fn indices(&self) -> impl Iterator<Item = Vec<usize>> + '_ {
        (0..self.len()).map(|number| {
            let mut rest = number;
            let mut indices = self.origin.clone();
            for (index, size) in indices.iter_mut().zip(&self.shape).rev() {
                *index += rest % size;
                rest /= size;
            }
            indices
        })
    }

    /// The places of its points among those of a grid of this shape, or of a larger chunk, in the
    /// same order.
    pub fn places_in(&self, whole: &[usize]) -> Vec<usize> {
        (0..self.len())
            .map(|number| {
                let (mut rest, mut place, mut stride) = (number, 0, 1);
                for ((first, size), whole) in self.origin.iter().zip(&self.shape).zip(whole).rev() {
                    place += (first + rest % size) * stride;
                    rest /= size;
                    stride *= whole;
                }
                place
            })
            .collect()
    }

    /// Its points, in the same order.
    pub fn points<'a>(&'a self, grid: &'a Grid) -> impl Iterator<Item = Setup> + 'a {
        let mut indices = self.origin.clone();
        let mut point = grid.point_at(&indices);
        (0..self.len()).map(move |_| {
            let this = point;
            // Only the quantities that change from one point to the next are computed.
            for (k, axis) in grid.axes().iter().enumerate().rev() {
                indices[k] += 1;
                let carries = indices[k] == self.origin[k] + self.shape[k];
                if carries {
                    indices[k] = self.origin[k];
                }
                axis.varies().set(&mut point, axis.value(indices[k]));
                if !carries {
                    break;
                }
            }
            this
        })
    }
}
