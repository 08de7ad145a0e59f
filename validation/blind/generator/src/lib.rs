//! Recordings with a concealed cause, made by equations that share nothing with the fitter.
