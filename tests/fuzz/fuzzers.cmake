# Each is a file of this folder.
set(FUZZERS calls images recordings shapes broad_phase scene_files tracks)
