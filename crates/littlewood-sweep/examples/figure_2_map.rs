//! Maps of the hoop of Figure 2: which starts jump, when, and how high. Writes a Zarr store, two Parquet folders and
//! three pictures into the folder that is named as the first argument.

use std::f64::consts::PI;
use std::path::PathBuf;

use littlewood::{HoopParameters, Limits, Start};
use littlewood_sweep::{
    Axis, Coordinate, Grid, Options, Picture, Point, Real, Shade, Size, Workers, ZarrStore, grid_to_parquet,
    grid_to_zarr,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("name a folder")?);
    let count = std::env::args().nth(2).map_or(Ok(400), |count| count.parse())?;
    let hoop = HoopParameters { mass_ratio: 1.0, offset: 1.0, inertia: 1.0, mu_s: 0.5, mu_k: 0.4 };
    let grid = Grid::new(
        Point { hoop, start: Start::at(0.0, 0.0) },
        vec![
            Axis::new(Coordinate::Theta, -PI, PI, count)?,
            Axis::new(Coordinate::ThetaRate, -4.0, 4.0, count)?,
        ],
    )?;
    let workers = Workers::new(None)?;
    let options = Options { resume: true, ..Options::default() };
    let limits = Limits::until(50.0);
    println!("{:?}", grid_to_zarr(&grid, limits, &folder.join("map.zarr"), &workers, &options)?);
    println!("{:?}", grid_to_parquet(&grid, limits, &folder.join("map.parquet"), &workers, &options)?);
    let store = ZarrStore::open(&folder.join("map.zarr"))?;
    for (name, shade) in [
        ("outcome", Shade::Class),
        ("lift_off_time", Shade::Column(Real::LiftOffTime)),
        ("jump_height", Shade::Column(Real::JumpHeight)),
    ] {
        let picture = Picture::of_store(&store, shade, Size::default())?;
        std::fs::write(folder.join(name).with_extension("png"), picture.png()?)?;
    }
    Ok(())
}
