//! Drivers that are called after a role.

use super::*;

const TABLE: &str = "time_s,load,p,T,x\n0,1,3,300,7\n1,2,4,301,8\n2,3,5,302,9\n";

fn read(columns: &str, units: &str, drivers: &str) -> Result<Recording, RecordingError> {
    with_toml(&format!("[columns]\nresponse = \"x\"\n{columns}[units]\nresponse = \"N\"\n{units}[drivers]\n{drivers}"), TABLE)
}

/// Three of fifteen recordings by others were refused for it.
#[test]
fn a_driver_called_after_a_role_is_the_column_of_that_role() {
    let drivers = read(
        "",
        "",
        "force = { column = \"load\", unit = \"mN\" }\npressure = { column = \"p\", unit = \"kPa\" }\ntemperature = { column = \"T\", unit = \"K\" }\n",
    )
    .unwrap();
    let columns = read(
        "force = \"load\"\npressure = \"p\"\ntemperature = \"T\"\n",
        "force = \"mN\"\npressure = \"kPa\"\ntemperature = \"K\"\n",
        "",
    )
    .unwrap();
    assert_eq!(drivers.inputs.pressure_pa.as_deref(), Some(&[3000.0, 4000.0, 5000.0][..]));
    assert_eq!((&drivers.inputs, &drivers.columns, &drivers.notes), (&columns.inputs, &columns.columns, &columns.notes));
    // a unit under [units] is that of the role, and one in the name does as well
    let by_units = read("", "force = \"mN\"\n", "force = { column = \"load\" }\n").unwrap();
    assert_eq!(by_units.inputs.force_n, columns.inputs.force_n);
    let by_name = with_toml("[drivers]\nforce = { column = \"push_mn\" }\n", "push_mn,capacitance_pf\n1,2\n2,3\n").unwrap();
    assert_eq!(by_name.inputs.force_n, Some(vec![1e-3, 2e-3]));
}

#[test]
fn columns_in_memory_and_told_ones_are_taken_alike() {
    let toml = "schema = \"truegap.recording/1\"\nfile = \"a\"\n[drivers]\nforce = { column = \"load\", unit = \"mN\" }\n";
    let table = [FrameColumn::numbers("load", &[1.0, 2.0]), FrameColumn::numbers("capacitance_pf", &[3.0, 4.0])];
    assert_eq!(Recording::from_columns("frame", toml, &table).unwrap().inputs.force_n, Some(vec![1e-3, 2e-3]));
    let told = |map: &str, toml: &str| {
        let told = Told { map: vec![map.parse().unwrap()], ..Told::default() };
        let toml = format!("schema = \"truegap.recording/1\"\nfile = \"a.csv\"\n[columns]\nresponse = \"x\"\n{toml}");
        Recording::from_text_told("a", &toml, TABLE, &told).unwrap().inputs.force_n
    };
    let millis = Some(vec![1e-3, 2e-3, 3e-3]);
    assert_eq!(told("driver.force=load:mN", ""), millis);
    // what is told goes before the TOML, whichever of the two ways names the role there
    assert_eq!(told("driver.force=load:mN", "force = \"p\"\n[units]\nforce = \"kN\"\n"), millis);
    assert_eq!(told("force=load:mN", "[drivers]\nforce = { column = \"p\", unit = \"V\" }\n"), millis);
    let folder = Folder::new();
    let (csv, map) = (
        folder.file("a.csv", TABLE.replace("p,T", "u,v")),
        ["response=x:N", "driver.force=load:mN"].map(|map| map.parse().unwrap()),
    );
    let sketch = truegap_core::recording::sketch(&csv, &Told { map: map.to_vec(), ..Told::default() }).unwrap();
    assert_eq!(Recording::open(folder.file("a.toml", &sketch.toml)).unwrap().inputs.force_n, millis, "{}", sketch.toml);
}

#[test]
fn what_is_no_column_of_its_role_is_refused_with_what_to_do() {
    let driver = |name: &str, unit: &str| format!("{name} = {{ column = \"p\"{unit} }}\n");
    let volts = message(read("", "", &driver("pressure", ", unit = \"V\"")));
    let other = "pressure_signal = { column = \"p\", unit = \"V\" }";
    for part in ["r.toml, line 8", "driver `pressure`", "`V`, the unit of column `p`", "is no unit of pressure", "kPa", other] {
        assert!(volts.contains(part), "`{part}` is not in: {volts}");
    }
    let both = message(read("pressure = \"T\"\n", "", &driver("pressure", ", unit = \"kPa\"")));
    assert!(both.contains("r.toml, line 9") && both.contains("[columns] (line 5)") && both.contains("`T`"), "{both}");
    let units = message(read("", "pressure = \"Pa\"\n", &driver("pressure", ", unit = \"kPa\"")));
    assert!(units.contains("r.toml, line 9") && units.contains("[units] (line 7)"), "{units}");
    let none = message(read("", "", &driver("pressure", "")));
    assert!(
        none.contains("line 8") && none.contains("no unit in its name; write pressure = { column = \"p\", unit = \"Pa\" }"),
        "{none}"
    );
    let lost = message(read("", "", "pressure = { column = \"q\", unit = \"Pa\" }\n"));
    assert!(lost.contains("line 8") && lost.contains("`q` is not in the header"), "{lost}");
    // before a column of the header that is called after the role is read in its place
    let near = message(with_toml(
        "[columns]\nresponse = \"x\"\n[units]\nresponse = \"N\"\n[drivers]\nforce = { column = \"forse\", unit = \"N\" }\n",
        "force,x\n0,1\n1,2\n",
    ));
    assert!(near.contains("line 8") && near.contains("`forse` is not in the header") && near.contains("force"), "{near}");
}
