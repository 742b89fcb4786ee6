//! A store read as the specification of Zarr v3 says. The tests of the Python package read stores
//! with Zarr itself.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

/// An array of a store.
pub(crate) struct Array {
    root: PathBuf,
    pub(crate) metadata: Value,
}

impl Array {
    pub(crate) fn open(store: &Path, name: &str) -> Self {
        let root = store.join(name);
        let metadata: Value =
            serde_json::from_slice(&fs::read(root.join("zarr.json")).unwrap()).unwrap();
        assert_eq!(
            (
                &metadata["zarr_format"],
                &metadata["node_type"],
                &metadata["chunk_key_encoding"]["name"]
            ),
            (&3.into(), &"array".into(), &"default".into())
        );
        let codecs = metadata["codecs"].as_array().unwrap();
        let names: Vec<&str> = codecs
            .iter()
            .map(|codec| codec["name"].as_str().unwrap())
            .collect();
        assert_eq!(names, ["bytes", "zstd"]);
        assert_eq!(codecs[0]["configuration"]["endian"], "little");
        Self { root, metadata }
    }

    pub(crate) fn attributes(&self) -> &Value {
        &self.metadata["attributes"]
    }

    pub(crate) fn dimensions(&self) -> Vec<&str> {
        self.metadata["dimension_names"]
            .as_array()
            .unwrap()
            .iter()
            .map(|name| name.as_str().unwrap())
            .collect()
    }

    pub(crate) fn shape(&self) -> Vec<usize> {
        numbers(&self.metadata["shape"])
    }

    /// All values, the last dimension fastest, each as its bytes.
    pub(crate) fn values<const N: usize>(&self, data_type: &str) -> Vec<[u8; N]> {
        assert_eq!(self.metadata["data_type"], data_type);
        let (shape, chunk) = (
            self.shape(),
            numbers(&self.metadata["chunk_grid"]["configuration"]["chunk_shape"]),
        );
        (0..shape.iter().product())
            .map(|number: usize| {
                let (mut rest, mut place) = (number, vec![0; shape.len()]);
                for (place, &size) in place.iter_mut().zip(&shape).rev() {
                    (*place, rest) = (rest % size, rest / size);
                }
                let key: String = place
                    .iter()
                    .zip(&chunk)
                    .map(|(place, size)| format!("/{}", place / size))
                    .collect();
                let file = fs::read(self.root.join(format!("c{key}"))).unwrap();
                let bytes =
                    zstd::bulk::decompress(&file, chunk.iter().product::<usize>() * N).unwrap();
                let within = place
                    .iter()
                    .zip(&chunk)
                    .fold(0, |sum, (place, size)| sum * size + place % size);
                bytes[within * N..][..N].try_into().unwrap()
            })
            .collect()
    }

    pub(crate) fn reals(&self) -> Vec<f64> {
        self.values("float64")
            .into_iter()
            .map(f64::from_le_bytes)
            .collect()
    }
}

fn numbers(value: &Value) -> Vec<usize> {
    value
        .as_array()
        .unwrap()
        .iter()
        .map(|number| usize::try_from(number.as_u64().unwrap()).unwrap())
        .collect()
}
