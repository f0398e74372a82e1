"""Constants of materials from measured impacts: `calibrate`."""
