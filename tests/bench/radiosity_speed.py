"""CPU time of lentray against stock POV-Ray where scenes have radiosity, and what a second thread brings.

All examples of Debian's povray-examples whose indirect light is radiosity alone, 160 x 120 without antialiasing. Whole
pictures on one thread, user + system time; the programs take turns, medians are compared. Beside them lentray's
part of it before the picture.

  tests/bench/radiosity_speed.py [--runs N] [--bin FOLDER] [--match WORD]
  tests/bench/radiosity_speed.py --threads      how much sooner two threads end the pass

Threads: the least wall time of the runs with one and with two, so that a busy machine disturbs least. A machine with
fewer than two idle processors tells nothing.

The exit status is 1 where a picture takes longer than stock's, or more than a third of its time at the median; with
--threads where two are less than 1.5 times as fast at the median.
"""
import pass_speed
import two_builds

SCENES = [f"radiosity/{name}" for name in (
    "radiosity_36", "radiosity_37", "radiosity2", "radiosity3", "rad_def_test_36", "rad_def_test_37", "patio-radio_36",
    "patio-radio_37", "cornell")] + [f"camera/mesh_camera/{name}" for name in (
        "baking_demo", "meshcam_ortho_demo", "meshcam_ortho_demo_uv", "meshcam_persp_compare", "meshcam_persp_demo",
        "meshcam_persp_demo_uv", "meshcam_stereo_demo")] + [
            "animations/raddem/raddem", "advanced/object_pattern", "advanced/blocks/stackerday",
            "advanced/blocks/stackernight", "advanced/diffuse_back", "gamma/gamma_showcase"]


def main():
    args = pass_speed.parser_of(__doc__)
    scenes = two_builds.examples(args.parser, [name for name in SCENES if args.match in name])
    return pass_speed.measure("radiosity", scenes, args)


if __name__ == "__main__":
    two_builds.main(main)
