//! Writes a made-up stack as GLB, viewer pages and VTU: `cargo run -p truegap-scene --example stack -- DIR`.
//!
//! The shape is that of a tactile sensor (discs of 7.5 mm radius, layers of 17 to 180 um); displacement and field are
//! formulas, not results.

use truegap_scene::Viewer;
use truegap_scene::colour::{ColourMap, Rgb};
use truegap_scene::glb::{Field, Provenance, Scene, suggested_exaggeration};
use truegap_scene::solid::{Layer, Sweep};
use truegap_scene::vtu::{Cells, Data, Grid};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::path::PathBuf::from(std::env::args().nth(1).ok_or("name the folder to write to")?);
    std::fs::create_dir_all(&folder)?;
    for (name, sweep) in [("full", Sweep::FULL), ("cut", Sweep::CUT_AWAY)] {
        let scene = stack(sweep);
        let glb = scene.to_glb()?;
        std::fs::write(folder.join(format!("{name}.glb")), &glb)?;
        std::fs::write(folder.join(format!("{name}.html")), Viewer::new(&scene.title, &glb).to_html())?;
    }
    let section = &stack(Sweep::FULL).layers[2];
    std::fs::write(folder.join("silicone.vtu"), grid(section).to_vtu()?)?;
    std::fs::write(folder.join("quadratic.vtu"), quadratic().to_vtu()?)?;
    Ok(())
}

/// The section of one layer with its displacement and field.
fn grid(layer: &Layer) -> Grid {
    let area = |&[a, b, c]: &[usize; 3]| {
        let [a, b, c] = [a, b, c].map(|p| layer.points[p]);
        0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    };
    Grid::new(layer.points.clone(), Cells::Triangles(layer.triangles.clone()))
        .on_points("temperature [°C]", Data::Scalar(layer.fields[0].clone()))
        .on_points("displacement [m]", Data::Vector(layer.displacement.clone()))
        .on_cells("area [m2]", Data::Scalar(layer.triangles.iter().map(area).collect()))
        .on_cells("region", Data::Label(vec![3; layer.triangles.len()]))
        .note("command", "cargo run -p truegap-scene --example stack -- DIR")
        .note("version", env!("CARGO_PKG_VERSION"))
}

fn stack(sweep: Sweep) -> Scene {
    let layers = vec![
        disc("lower polyimide", 0xC58B2A, [0.0, 25e-6]),
        disc("lower copper", 0xB87333, [25e-6, 42e-6]),
        disc("silicone", 0x8FB8C9, [42e-6, 222e-6]),
        disc("upper copper", 0xB87333, [222e-6, 239e-6]),
        disc("upper polyimide", 0xC58B2A, [239e-6, 264e-6]),
    ];
    let exaggeration = suggested_exaggeration(&layers);
    Scene {
        title: "Made-up stack".into(),
        layers,
        fields: vec![
            Field { name: "temperature".into(), unit: "°C".into(), map: ColourMap::Sequential, range: None },
            Field { name: "axial displacement".into(), unit: "µm".into(), map: ColourMap::Diverging, range: None },
        ],
        sweep,
        exaggeration,
        provenance: Provenance {
            source: "formulas in examples/stack.rs".into(),
            command: "cargo run -p truegap-scene --example stack".into(),
            version: env!("CARGO_PKG_VERSION").into(),
            notes: vec![("load".into(), "none".into())],
        },
    }
}

/// A quarter of a disc of radius one as one quadratic triangle with a curved side, without notes (meshio reads no text).
fn quadratic() -> Grid {
    let (half, middle) = (0.5, std::f64::consts::FRAC_1_SQRT_2);
    let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [half, 0.0], [middle, middle], [0.0, half]];
    let radius = points.iter().map(|p| f64::hypot(p[0], p[1])).collect();
    Grid::new(points, Cells::QuadraticTriangles(vec![[0, 1, 2, 3, 4, 5]]))
        .on_points("radius [m]", Data::Scalar(radius))
        .on_cells("stress [Pa]", Data::Tensor(vec![[1.0, 2.0, 3.0, 4.0]]))
}

/// A disc of radius 7.5 mm, bent upwards and thinned, warmer in the middle and on top.
fn disc(name: &str, colour: u32, [z0, z1]: [f64; 2]) -> Layer {
    let (radius, nr, nz) = (7.5e-3, 40, 4);
    let points: Vec<[f64; 2]> = (0..=nz)
        .flat_map(|j| (0..=nr).map(move |i| (i, j)))
        .map(|(i, j)| [radius * f64::from(i) / f64::from(nr), z0 + (z1 - z0) * f64::from(j) / f64::from(nz)])
        .collect();
    let (nr, nz) = (nr as usize, nz as usize);
    let triangles = (0..nz)
        .flat_map(|j| (0..nr).map(move |i| j * (nr + 1) + i))
        .flat_map(|a| [[a, a + 1, a + nr + 2], [a, a + nr + 2, a + nr + 1]])
        .collect();
    let bent = |p: &[f64; 2]| {
        let t = p[0] / radius;
        [-2e-6 * t * (p[1] / 264e-6), 12e-6 * t * t - 0.05 * p[1]]
    };
    let warmth = |p: &[f64; 2]| 20.0 + 30.0 * (p[1] / 264e-6) * (-(p[0] / 4e-3).powi(2)).exp();
    Layer {
        name: name.into(),
        colour: Rgb::hex(colour),
        displacement: points.iter().map(bent).collect(),
        fields: vec![points.iter().map(warmth).collect(), points.iter().map(|p| 1e6 * bent(p)[1]).collect()],
        points,
        triangles,
    }
}
