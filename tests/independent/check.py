#!/usr/bin/env python3
"""Judges a dump of `lt render --dump DIR` by Intel Embree, which shares no code with this repository.

  python3 check.py SCENE.glb DUMP_DIR [--light-dir x,y,z] [--ground y,half] [--channel visibility] [--self-test]

For every pixel, two questions: does Embree see the same surface there (`seen`), and does it find the same light or
shadow at the point that lt reports (`shadow`)? Both must differ in at most --max-ppm of the valid pixels.
Exit status: 0 agreed, 1 did not, 2 cannot judge this input, 77 skipped because a package is missing. With
--self-test also 1 if answers turned over on purpose go unnoticed.
"""
import argparse, json, pathlib, sys

try:
    import numpy as np, OpenEXR
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene
    from model import Model, Refused
except ImportError as missing:
    print(f"skipped: {missing}; python3 -m pip install embreex numpy pillow OpenEXR")
    sys.exit(77)


class Tracer:
    """Nearest surfaces by Embree's robust mode; a hole is passed by starting again just behind it."""

    def __init__(self, model):
        self.model, self.scene = model, EmbreeScene(robust=True)
        self.mesh = TriangleMesh(self.scene, np.ascontiguousarray(model.corners, np.float32))
        self.least_step = 1e-9 * np.abs(model.corners).max()

    def distance(self, origin, direction):
        """Of the first surface, infinite without one."""
        found, passed, active = np.full(len(origin), np.inf), np.zeros(len(origin)), np.arange(len(origin))
        while len(active):
            start = origin[active] + direction[active] * passed[active, None]
            hit = self.scene.run(start.astype(np.float32), direction[active].astype(np.float32), output=1)
            is_hit = hit["primID"] >= 0
            active, far, u, v = active[is_hit], *(hit[k][is_hit].astype(float) for k in ("tfar", "u", "v"))
            passed[active] += far
            covered = self.model.covers(hit["primID"][is_hit].astype(int), u, v)
            found[active[covered]] = passed[active[covered]]
            active = active[~covered]
            passed[active] += 2e-6 * (np.abs(origin[active]).max(1) + passed[active]) + self.least_step
        return found


def view_directions(camera, height, width):
    forward = unit(np.subtract(camera["target"], camera["eye"]))
    right = unit(np.cross(forward, camera["up"]))
    half = np.tan(np.radians(camera["fov_deg"]) / 2)
    x = ((np.arange(width) + 0.5) / width * 2 - 1) * half * width / height
    y = (1 - (np.arange(height) + 0.5) / height * 2) * half
    rays = forward + x[None, :, None] * right + y[:, None, None] * np.cross(right, forward)
    return unit(rays).reshape(-1, 3)


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def numbers(text):
    return [float(word) for word in text.split(",")]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scene", type=pathlib.Path)
    options.add_argument("dump", type=pathlib.Path)
    options.add_argument("--light-dir", type=numbers, help="direction in which the light travels; else the dump's")
    options.add_argument("--ground", type=numbers, help="y,half: the square that lt was asked to add")
    options.add_argument("--channel", default="reference", help="or visibility: what the technique says")
    options.add_argument("--offset", type=float, default=1e-6, help="of ray origins, times |point| + |point - eye|")
    options.add_argument("--max-ppm", type=float, default=100)
    options.add_argument("--self-test", action="store_true", help="also turn one answer in 1000 over: must be caught")
    args = options.parse_args()

    camera = json.loads((args.dump / "camera.json").read_text())
    channels = OpenEXR.File(str(args.dump / "frame.exr"), separate_channels=True).channels()
    height, width = channels["position.X"].pixels.shape
    point, normal = (
        np.stack([channels[f"{name}.{axis}"].pixels.astype(float).ravel() for axis in "XYZ"], 1)
        for name in ("position", "normal")
    )
    is_lit = channels[f"{args.channel}.Y"].pixels.ravel() > 0.5
    light, eye = args.light_dir or camera["light_dir"], np.array(camera["eye"])
    if light is None:
        raise Refused("a light without direction")
    to_light = -unit(np.array(light))
    model = Model(args.scene)
    if args.ground:
        model.add_ground(*args.ground)
    tracer = Tracer(model)

    is_valid = np.linalg.norm(normal, axis=1) > 0.5
    depth = np.where(is_valid, np.linalg.norm(point - eye, axis=1), np.inf)
    rays = view_directions(camera, height, width)
    embree_depth = tracer.distance(np.broadcast_to(eye, rays.shape), rays)
    with np.errstate(invalid="ignore"):
        sees_other = (depth != embree_depth) & ~(np.abs(depth - embree_depth) <= 1e-3 * depth)

    facing = np.nonzero(is_valid & (normal @ to_light > 0))[0]
    reach = np.abs(point[facing]).max(1) + depth[facing]
    origin = point[facing] + normal[facing] * (args.offset * reach)[:, None]
    embree_lit = np.zeros(len(is_lit), bool)
    embree_lit[facing] = np.isinf(tracer.distance(origin, np.broadcast_to(to_light, origin.shape)))
    differs = is_valid & (is_lit != embree_lit)

    def ppm(count, of=is_valid):
        return round(1e6 * int(np.sum(count)) / max(int(np.sum(of)), 1), 1)

    passes = is_valid.any() and ppm(sees_other) <= args.max_ppm and ppm(differs) <= args.max_ppm
    report = {
        "scene": args.scene.name, "triangles": len(model.corners), "valid": int(is_valid.sum()),
        "light_facing": len(facing), "lit": int((is_lit & is_valid).sum()),
        "false_lit": int((differs & is_lit).sum()), "false_shadowed": int((differs & ~is_lit).sum()),
        "shadow_ppm": ppm(differs), "shadow_ppm_of_facing": ppm(differs, np.ones(len(facing))),
        "seen_differ": int(sees_other.sum()), "seen_ppm": ppm(sees_other),
        "first_differing_x_y": [[int(i) % width, int(i) // width] for i in np.nonzero(differs)[0][:8]],
    }
    if args.self_test:
        differs[facing[::1000]] ^= True
        report["shadow_ppm_after_damage"] = ppm(differs)
        passes = passes and ppm(differs) > args.max_ppm
    print(json.dumps(report | {"passes": bool(passes)}, indent=1))
    sys.exit(not passes)


if __name__ == "__main__":
    try:
        main()
    except (Refused, OSError, KeyError, ValueError, RuntimeError) as why:
        print(f"cannot judge: {type(why).__name__}: {why}", file=sys.stderr)
        sys.exit(2)
