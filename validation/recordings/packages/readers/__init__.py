"""What reads the files of one package: a module a package of sources.toml."""
