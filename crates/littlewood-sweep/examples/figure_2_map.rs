//! Maps of the hoop of Figure 2: which starts jump, when, and how high. Writes a Zarr store, two
//! Parquet folders and three pictures into the folder that is named as the first argument.

use std::f64::consts::PI;
use std::path::PathBuf;

use littlewood::tables::{Quantity, Setup, SummaryColumn};
use littlewood::{HoopParameters, Limits, Start};
use littlewood_sweep::{
    Axis, Grid, Options, Picture, PictureSize, Shade, Target, Workers, ZarrStore, sweep_grid,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("name a folder")?);
    let count = std::env::args()
        .nth(2)
        .map_or(Ok(400), |count| count.parse())?;
    let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    let grid = Grid::new(
        Setup::new(hoop, Start::at(0.0, 0.0)),
        vec![
            Axis::new(Quantity::Theta, -PI, PI, count)?,
            Axis::new(Quantity::ThetaRate, -4.0, 4.0, count)?,
        ],
    )?;
    let workers = Workers::new(None)?;
    let options = Options {
        resume: true,
        ..Options::default()
    };
    let limits = Limits::until(50.0);
    println!(
        "{:?}",
        sweep_grid(
            &grid,
            limits,
            &[Target::Zarr(&folder.join("map.zarr"))],
            None,
            &workers,
            &options
        )?
    );
    println!(
        "{:?}",
        sweep_grid(
            &grid,
            limits,
            &[Target::Parquet(&folder.join("map.parquet"))],
            None,
            &workers,
            &options
        )?
    );
    let store = ZarrStore::open(&folder.join("map.zarr"))?;
    for (name, shade) in [
        ("outcome", Shade::Class),
        ("lift_off_time", Shade::Column(SummaryColumn::LiftOffTime)),
        ("jump_height", Shade::Column(SummaryColumn::JumpHeight)),
    ] {
        let picture = Picture::of_store(&store, shade, PictureSize::default())?;
        std::fs::write(folder.join(name).with_extension("png"), picture.png()?)?;
    }
    Ok(())
}
