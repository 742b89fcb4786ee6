//! Arrays of a store: their metadata, and chunks to bytes and back.

use core::num::NonZeroU64;
use std::sync::Arc;

use zarrs::array::builder::ArrayBuilderFillValue;
use zarrs::array::codec::ZstdCodec;
use zarrs::array::{
    Array, ArrayBuilder, ArrayBytes, ArrayMetadata, ArrayMetadataOptions, ArrayToBytesCodecTraits as _,
    CodecOptions, DataType,
};
use zarrs::storage::store::MemoryStore;

use crate::attributes::Attributes;
use crate::store::StoreError;

/// An array that is described here; its chunks are on disk.
pub(super) type MemoryArray = Array<MemoryStore>;

pub(super) fn widths(sizes: &[usize]) -> Vec<u64> {
    sizes.iter().map(|&size| size as u64).collect()
}

fn nonzero(sizes: &[usize]) -> Vec<NonZeroU64> {
    sizes.iter().map(|&size| NonZeroU64::new(size as u64).unwrap_or(NonZeroU64::MIN)).collect()
}

pub(super) fn array(
    name: &str,
    shape: &[usize],
    chunk: &[usize],
    data_type: DataType,
    fill_value: ArrayBuilderFillValue,
    dimensions: &[&str],
    attributes: Attributes,
) -> Result<MemoryArray, StoreError> {
    ArrayBuilder::new(widths(shape), widths(chunk), data_type, fill_value)
        // The checksum makes every reader notice a damaged chunk.
        .bytes_to_bytes_codecs(vec![Arc::new(ZstdCodec::new(3, true))])
        .dimension_names(Some(dimensions.iter().copied()))
        .attributes(attributes)
        .build(Arc::new(MemoryStore::new()), &format!("/{name}"))
        .map_err(StoreError::encoding(name))
}

pub(super) fn metadata(array: &MemoryArray) -> ArrayMetadata {
    array.metadata_opt(&ArrayMetadataOptions::default().with_include_zarrs_metadata(false))
}

pub(super) fn encode(
    name: &str,
    array: &MemoryArray,
    shape: &[usize],
    bytes: Vec<u8>,
) -> Result<Vec<u8>, StoreError> {
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
        .map_err(StoreError::encoding(name))
}

pub(super) fn decode(array: &MemoryArray, shape: &[usize], bytes: Vec<u8>) -> Result<Vec<u8>, String> {
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
