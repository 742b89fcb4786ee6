//! Grids as Zarr v3: a group with an array for each column, dimensions named and labelled.
//!
//! ```text
//! map.zarr/
//!   zarr.json            group: parameters, status, and the metadata of all arrays (consolidated)
//!   theta/  theta_rate/  coordinates, one array an axis
//!   outcome/  sequence/  …  one array a column, its chunks in c/
//!   outcome/_chunks.txt  finished chunks with their checksums
//! ```
//!
//! `xarray.open_zarr` opens the group as a data set with coordinates, units and long names. Chunks that are not computed
//! yet read as the fill value: [`NOT_COMPUTED`] for `outcome`, NaN for real numbers, zero for the rest.

use core::num::NonZeroU64;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use littlewood::Limits;
use serde_json::{Map, Value, json};
use zarrs::array::builder::ArrayBuilderFillValue;
use zarrs::array::codec::ZstdCodec;
use zarrs::array::data_type;
use zarrs::array::{
    Array, ArrayBuilder, ArrayBytes, ArrayMetadata, ArrayMetadataOptions, ArrayToBytesCodecTraits as _,
    CodecOptions, DataType,
};
use zarrs::storage::store::MemoryStore;

use crate::axis::Axis;
use crate::chunk::{Chunk, Chunks};
use crate::columns::{Columns, Real};
use crate::compute::{Refused, Workers};
use crate::description::Description;
use crate::error::{StoreError, SweepError};
use crate::grid::Grid;
use crate::outcome::{NOT_COMPUTED, codes};
use crate::point::Point;
use crate::run::{Format, Options, Report, Source, StoreFile, broken_chunks, run};

const METADATA: &str = "zarr.json";

/// What the letters of a sequence mean; three bits a phase, the first phase lowest.
const SEQUENCE_LEGEND: [(&str, &str); 8] = [
    ("0", "end of the sequence"),
    ("1", "R: rolling"),
    ("2", "-: sliding with negative slip velocity"),
    ("3", "+: sliding with positive slip velocity"),
    ("4", "n: gliding with negative slip velocity"),
    ("5", "g: gliding with positive slip velocity"),
    ("6", "G: gliding without slip"),
    ("7", "F: flight"),
];

/// Computes a grid into a Zarr store.
///
/// Memory stays flat: a few chunks are held, whatever the size of the grid. Every file is written whole or not at all. A
/// run that was cancelled or killed goes on with `resume`, and the store is then the same, byte for byte, as that of a
/// run that was not.
///
/// # Errors
/// A store that is there already, unless it is resumed; a store of other parameters, which is left as it is; a disk
/// that is full; a limit without meaning.
pub fn grid_to_zarr(
    grid: &Grid,
    limits: Limits,
    path: &Path,
    workers: &Workers,
    options: &Options<'_>,
) -> Result<Report, SweepError> {
    let chunks = Chunks::new(grid, options.chunk_points);
    let description = Description::of_grid(grid, limits, chunks.shape());
    let layout = Layout::new(grid, chunks.clone(), description.clone())?;
    let mut source = GridSource { grid, chunks };
    run(&mut source, &layout, &description, limits, path, workers, options)
}

/// A grid, chunk by chunk.
pub(crate) struct GridSource<'a> {
    pub(crate) grid: &'a Grid,
    pub(crate) chunks: Chunks,
}

impl Source for GridSource<'_> {
    fn total(&self) -> u64 {
        self.grid.len()
    }

    fn count(&self) -> usize {
        self.chunks.count()
    }

    fn points_of(&self, chunk: usize) -> u64 {
        self.chunks.chunk(chunk).len() as u64
    }

    fn points(&mut self, chunk: usize) -> Result<Vec<Point>, SweepError> {
        Ok(self.chunks.chunk(chunk).points(self.grid).collect())
    }

    fn refused(&self, _: usize, refused: Refused) -> SweepError {
        refused.error.into()
    }
}

/// A column of the store.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Variable {
    Outcome,
    Sequence,
    Transitions,
    Painleve,
    Real(Real),
}

impl Variable {
    fn all() -> impl Iterator<Item = Self> {
        [Self::Outcome, Self::Sequence, Self::Transitions, Self::Painleve]
            .into_iter()
            .chain(Real::ALL.into_iter().map(Self::Real))
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Outcome => "outcome",
            Self::Sequence => "sequence",
            Self::Transitions => "transitions",
            Self::Painleve => "painleve",
            Self::Real(column) => column.name(),
        }
    }

    fn data_type(self) -> DataType {
        match self {
            Self::Outcome | Self::Painleve => data_type::uint8(),
            Self::Sequence => data_type::uint64(),
            Self::Transitions => data_type::uint32(),
            Self::Real(_) => data_type::float64(),
        }
    }

    fn fill_value(self) -> ArrayBuilderFillValue {
        match self {
            Self::Outcome => NOT_COMPUTED.into(),
            Self::Painleve => 0_u8.into(),
            Self::Sequence => 0_u64.into(),
            Self::Transitions => 0_u32.into(),
            Self::Real(_) => f64::NAN.into(),
        }
    }

    fn attributes(self) -> Map<String, Value> {
        let attributes = match self {
            Self::Outcome => json!({
                "long_name": "outcome",
                "flag_values": codes().map(|(code, _)| code).collect::<Vec<_>>(),
                "flag_meanings": codes().map(|(_, name)| name).collect::<Vec<_>>().join(" "),
            }),
            Self::Sequence => {
                let legend: Map<String, Value> = SEQUENCE_LEGEND
                    .iter()
                    .map(|&(code, meaning)| (code.to_owned(), meaning.into()))
                    .collect();
                json!({
                    "long_name": "sequence of phases",
                    "encoding": "3 bits a phase, the first phase lowest, up to 20 phases; bit 63 is set if there are more",
                    "legend": legend,
                })
            }
            Self::Transitions => json!({ "long_name": "number of transitions", "units": "1" }),
            Self::Painleve => json!({
                "long_name": "whether the motion met a Painlevé paradox",
                "flag_values": [0, 1],
                "flag_meanings": "no yes",
            }),
            Self::Real(column) => json!({ "long_name": column.long_name(), "units": column.unit() }),
        };
        match attributes {
            Value::Object(map) => map,
            _ => Map::new(),
        }
    }

    /// The values of a chunk in a box of the full chunk size, little-endian.
    fn bytes(self, columns: &Columns, places: &[usize], size: usize) -> Vec<u8> {
        fn spread<const N: usize>(
            places: &[usize],
            size: usize,
            fill: [u8; N],
            value: impl Fn(usize) -> [u8; N],
        ) -> Vec<u8> {
            let mut bytes = if places.len() == size { vec![0; size * N] } else { fill.repeat(size) };
            for (i, &place) in places.iter().enumerate() {
                bytes[place * N..(place + 1) * N].copy_from_slice(&value(i));
            }
            bytes
        }
        match self {
            Self::Outcome => spread(places, size, [NOT_COMPUTED], |i| [columns.outcome[i]]),
            Self::Painleve => spread(places, size, [0], |i| [columns.painleve[i]]),
            Self::Sequence => spread(places, size, [0; 8], |i| columns.sequence[i].to_le_bytes()),
            Self::Transitions => spread(places, size, [0; 4], |i| columns.transitions[i].to_le_bytes()),
            Self::Real(column) => {
                let values = columns.real(column);
                spread(places, size, f64::NAN.to_le_bytes(), |i| values[i].to_le_bytes())
            }
        }
    }
}

type MemoryArray = Array<MemoryStore>;

/// The arrays of a store.
struct Layout {
    chunks: Chunks,
    description: Description,
    coordinates: Vec<(Axis, MemoryArray)>,
    variables: Vec<(Variable, MemoryArray)>,
}

fn encoding<E: core::fmt::Display>(what: &str) -> impl FnOnce(E) -> StoreError + '_ {
    move |error| StoreError::Encoding { what: what.to_owned(), reason: error.to_string() }
}

fn widths(sizes: &[usize]) -> Vec<u64> {
    sizes.iter().map(|&size| size as u64).collect()
}

fn nonzero(sizes: &[usize]) -> Vec<NonZeroU64> {
    sizes.iter().map(|&size| NonZeroU64::new(size as u64).unwrap_or(NonZeroU64::MIN)).collect()
}

impl Layout {
    fn new(grid: &Grid, chunks: Chunks, description: Description) -> Result<Self, StoreError> {
        let names: Vec<&str> = grid.axes().iter().map(|axis| axis.coordinate().name()).collect();
        let coordinates = grid
            .axes()
            .iter()
            .map(|axis| {
                let coordinate = axis.coordinate();
                let name = coordinate.name();
                let mut attributes = Map::new();
                attributes.insert("long_name".to_owned(), coordinate.long_name().into());
                attributes.insert("units".to_owned(), coordinate.unit().into());
                let shape = [axis.count()];
                // The whole axis is one chunk: it is read with the metadata, and small beside a column.
                array(name, &shape, &shape, data_type::float64(), f64::NAN.into(), &[name], attributes)
                    .map(|array| (*axis, array))
            })
            .collect::<Result<_, _>>()?;
        let shape = grid.shape();
        let variables = Variable::all()
            .map(|variable| {
                array(
                    variable.name(),
                    &shape,
                    chunks.shape(),
                    variable.data_type(),
                    variable.fill_value(),
                    &names,
                    variable.attributes(),
                )
                .map(|array| (variable, array))
            })
            .collect::<Result<_, _>>()?;
        Ok(Self { chunks, description, coordinates, variables })
    }

    fn arrays(&self) -> impl Iterator<Item = (&'static str, &MemoryArray)> {
        let coordinates = self.coordinates.iter().map(|(axis, array)| (axis.coordinate().name(), array));
        coordinates.chain(self.variables.iter().map(|(variable, array)| (variable.name(), array)))
    }
}

fn array(
    name: &str,
    shape: &[usize],
    chunk: &[usize],
    data_type: DataType,
    fill_value: ArrayBuilderFillValue,
    dimensions: &[&str],
    attributes: Map<String, Value>,
) -> Result<MemoryArray, StoreError> {
    ArrayBuilder::new(widths(shape), widths(chunk), data_type, fill_value)
        // The checksum makes every reader notice a damaged chunk.
        .bytes_to_bytes_codecs(vec![Arc::new(ZstdCodec::new(3, true))])
        .dimension_names(Some(dimensions.iter().copied()))
        .attributes(attributes)
        .build(Arc::new(MemoryStore::new()), &format!("/{name}"))
        .map_err(encoding(name))
}

fn metadata(array: &MemoryArray) -> ArrayMetadata {
    array.metadata_opt(&ArrayMetadataOptions::default().with_include_zarrs_metadata(false))
}

fn encode(name: &str, array: &MemoryArray, shape: &[usize], bytes: Vec<u8>) -> Result<Vec<u8>, StoreError> {
    array
        .codecs()
        .encode(
            ArrayBytes::new_flen(bytes),
            &nonzero(shape),
            array.data_type(),
            array.fill_value(),
            &CodecOptions::default().with_concurrent_target(1),
        )
        .map(std::borrow::Cow::into_owned)
        .map_err(encoding(name))
}

fn pretty(what: &str, value: &impl serde::Serialize) -> Result<Vec<u8>, StoreError> {
    let mut text = serde_json::to_vec_pretty(value).map_err(encoding(what))?;
    text.push(b'\n');
    Ok(text)
}

impl Format for Layout {
    fn header_path(&self) -> &'static str {
        METADATA
    }

    fn manifest_path(&self) -> &'static str {
        // Within an array: readers that list the members of the group would complain of a file there.
        "outcome/_chunks.txt"
    }

    fn header(&self, complete: bool) -> Result<Vec<u8>, StoreError> {
        let arrays = self
            .arrays()
            .map(|(name, array)| {
                Ok((name.to_owned(), serde_json::to_value(metadata(array)).map_err(encoding(name))?))
            })
            .collect::<Result<Map<String, Value>, StoreError>>()?;
        pretty(
            METADATA,
            &json!({
                "zarr_format": 3,
                "node_type": "group",
                "attributes": {
                    "title": "motions of a loaded hoop",
                    "program": "littlewood-sweep",
                    "status": if complete { "complete" } else { "partial" },
                    "run": self.description.0,
                },
                "consolidated_metadata": {
                    "kind": "inline",
                    "must_understand": false,
                    "metadata": arrays,
                },
            }),
        )
    }

    fn read_header(&self, header: &Value) -> Option<(Value, bool)> {
        read_attributes(header)
    }

    fn prelude(&self) -> Result<Vec<StoreFile>, StoreError> {
        let mut files = Vec::new();
        for (name, array) in self.arrays() {
            files.push((Path::new(name).join(METADATA), pretty(name, &metadata(array))?));
        }
        for (axis, array) in &self.coordinates {
            let name = axis.coordinate().name();
            let bytes = axis.values().flat_map(f64::to_le_bytes).collect();
            files.push((
                PathBuf::from(array.chunk_key(&[0]).as_str()),
                encode(name, array, &[axis.count()], bytes)?,
            ));
        }
        Ok(files)
    }

    fn paths(&self, chunk: usize) -> Vec<PathBuf> {
        let place = widths(&self.chunks.chunk(chunk).place);
        self.variables.iter().map(|(_, array)| PathBuf::from(array.chunk_key(&place).as_str())).collect()
    }

    fn encode(&self, chunk: usize, _: &[Point], columns: &Columns) -> Result<Vec<StoreFile>, StoreError> {
        use rayon::prelude::*;

        let full = self.chunks.shape();
        let size: usize = full.iter().product();
        let places = places_in_full_chunk(&self.chunks.chunk(chunk), full);
        let files: Vec<Result<Vec<u8>, StoreError>> = self
            .variables
            .par_iter()
            .map(|(variable, array)| {
                encode(variable.name(), array, full, variable.bytes(columns, &places, size))
            })
            .collect();
        self.paths(chunk).into_iter().zip(files).map(|(path, bytes)| Ok((path, bytes?))).collect()
    }
}

fn read_attributes(header: &Value) -> Option<(Value, bool)> {
    let attributes = header.get("attributes")?;
    if attributes.get("program")?.as_str()? != "littlewood-sweep" {
        return None;
    }
    let complete = attributes.get("status")?.as_str()? == "complete";
    Some((attributes.get("run")?.clone(), complete))
}

/// Where the points of a chunk, which may be cut off at the far end of an axis, stand in a chunk of full size.
fn places_in_full_chunk(chunk: &Chunk, full: &[usize]) -> Vec<usize> {
    (0..chunk.len())
        .map(|number| {
            let (mut rest, mut place, mut stride) = (number, 0, 1);
            for (size, full) in chunk.shape.iter().zip(full).rev() {
                place += rest % size * stride;
                rest /= size;
                stride *= full;
            }
            place
        })
        .collect()
}

/// A Zarr store of a grid, for reading.
#[derive(Debug)]
pub struct ZarrStore {
    root: PathBuf,
    grid: Grid,
    limits: Limits,
    complete: bool,
    layout: Layout,
}

impl core::fmt::Debug for Layout {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Layout").field("chunks", &self.chunks).finish_non_exhaustive()
    }
}

impl ZarrStore {
    /// Opens a store that [`grid_to_zarr`] has made, complete or not.
    ///
    /// # Errors
    /// If there is none, or its metadata make no sense.
    pub fn open(path: &Path) -> Result<Self, StoreError> {
        let file = path.join(METADATA);
        let bytes =
            std::fs::read(&file).map_err(|source| StoreError::Unreadable { path: file.clone(), source })?;
        let header: Value = serde_json::from_slice(&bytes)
            .map_err(|error| StoreError::DamagedMetadata { path: file.clone(), reason: error.to_string() })?;
        let (run, complete) =
            read_attributes(&header).ok_or_else(|| StoreError::NotAStore { path: path.to_owned() })?;
        let (grid, limits, shape) = Description::grid(&run).ok_or_else(|| StoreError::DamagedMetadata {
            path: file,
            reason: "the attribute \"run\" does not describe a grid".to_owned(),
        })?;
        let chunks = Chunks::of_shape(&grid, shape);
        let layout = Layout::new(&grid, chunks, Description(run))?;
        Ok(Self { root: path.to_owned(), grid, limits, complete, layout })
    }

    /// The grid.
    #[must_use]
    pub const fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The limits of the motions.
    #[must_use]
    pub const fn limits(&self) -> Limits {
        self.limits
    }

    /// Whether all chunks are said to be there.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.complete
    }

    /// How the grid is cut into chunks.
    #[must_use]
    pub const fn chunks(&self) -> &Chunks {
        &self.layout.chunks
    }

    /// The numbers of chunks that are missing, or whose files do not have the checksum that was noted.
    ///
    /// # Errors
    /// If the list of finished chunks is damaged.
    pub fn broken_chunks(&self) -> Result<Vec<usize>, StoreError> {
        let broken =
            broken_chunks(&self.root, &self.layout, self.layout.chunks.count(), &self.layout.description)?;
        Ok(broken.into_iter().collect())
    }

    /// The results of a chunk, in the order of its points; none if it has not been computed.
    ///
    /// # Errors
    /// If a file of it cannot be read or decoded.
    pub fn columns(&self, number: usize) -> Result<Option<Columns>, StoreError> {
        let full = self.layout.chunks.shape();
        let places = places_in_full_chunk(&self.layout.chunks.chunk(number), full);
        let mut columns = Columns::blank(places.len());
        for ((variable, array), path) in self.layout.variables.iter().zip(self.layout.paths(number)) {
            let path = self.root.join(path);
            let encoded = match std::fs::read(&path) {
                Ok(bytes) => bytes,
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
                Err(source) => return Err(StoreError::Unreadable { path, source }),
            };
            let bytes = decode(array, full, encoded)
                .map_err(|reason| StoreError::DamagedChunk { path: path.clone(), reason })?;
            variable.read(&bytes, &places, &mut columns);
        }
        Ok(Some(columns))
    }
}

fn decode(array: &MemoryArray, shape: &[usize], bytes: Vec<u8>) -> Result<Vec<u8>, String> {
    array
        .codecs()
        .decode(
            bytes.into(),
            &nonzero(shape),
            array.data_type(),
            array.fill_value(),
            &CodecOptions::default().with_concurrent_target(1),
        )
        .map_err(|error| error.to_string())?
        .into_fixed()
        .map(std::borrow::Cow::into_owned)
        .map_err(|error| error.to_string())
}

impl Variable {
    /// Takes the values of a chunk out of a box of the full chunk size.
    fn read(self, bytes: &[u8], places: &[usize], columns: &mut Columns) {
        fn word<const N: usize>(bytes: &[u8], place: usize) -> [u8; N] {
            core::array::from_fn(|i| bytes[place * N + i])
        }
        for (i, &place) in places.iter().enumerate() {
            match self {
                Self::Outcome => columns.outcome[i] = bytes[place],
                Self::Painleve => columns.painleve[i] = bytes[place],
                Self::Sequence => columns.sequence[i] = u64::from_le_bytes(word(bytes, place)),
                Self::Transitions => columns.transitions[i] = u32::from_le_bytes(word(bytes, place)),
                Self::Real(column) => {
                    columns.reals[column as usize][i] = f64::from_le_bytes(word(bytes, place));
                }
            }
        }
    }
}
