"""Results in other formats: files that appear whole, CSV read back, tables of pandas, xarray and HTML, NetCDF."""
