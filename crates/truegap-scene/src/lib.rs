//! Surfaces and fields as glTF, VTU and figures.
