//! The hash of a digest.

/// FNV-1a, 64 bits.
pub(crate) struct Hash(u64);

impl Hash {
    pub(crate) const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    pub(crate) fn word(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// The bits of a number. There is one NaN: which bits arithmetic gives one is not specified.
    pub(crate) fn number(&mut self, number: f64) {
        self.word(if number.is_nan() {
            f64::NAN.to_bits()
        } else {
            number.to_bits()
        });
    }

    pub(crate) const fn finish(&self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::Hash;

    /// The hashes of no bytes, and of "chongo was here!\n", as Fowler, Noll and Vo list them.
    #[test]
    fn it_is_fnv_1a() {
        assert_eq!(Hash::new().finish(), 0xcbf2_9ce4_8422_2325);
        let mut hash = Hash::new();
        hash.word(u64::from_le_bytes(*b"chongo w"));
        hash.word(u64::from_le_bytes(*b"as here!"));
        let last = (hash.finish() ^ u64::from(b'\n')).wrapping_mul(0x0100_0000_01b3);
        assert_eq!(last, 0x4681_0940_eff5_f915);
    }

    #[test]
    fn every_nan_counts_the_same() {
        let of = |number: f64| {
            let mut hash = Hash::new();
            hash.number(number);
            hash.finish()
        };
        assert_eq!(of(f64::NAN), of(-f64::NAN));
        assert_ne!(of(0.0), of(-0.0));
    }
}
