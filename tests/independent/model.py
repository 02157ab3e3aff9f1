"""The little of glTF 2.0 that shadows depend on: triangles in world space, and where surfaces have holes."""

import io, json, struct

import numpy as np
from PIL import Image

COMPONENT = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
REPEAT, MIRROR, CLAMP, NEAREST = 10497, 33648, 33071, 9728


class Refused(Exception):
    """The file holds what this reader does not understand."""


class Model:
    """Triangles of a .glb in world space, and what decides where their surfaces have holes."""

    def __init__(self, path):
        data, at, chunks = path.read_bytes(), 12, {}
        if data[:4] != b"glTF":
            raise Refused(f"{path} is not a .glb file")
        while at < len(data):
            size, kind = struct.unpack_from("<I4s", data, at)
            chunks[kind] = data[at + 8 : at + 8 + size]
            at += 8 + size
        self.json, self.bin = json.loads(chunks[b"JSON"]), chunks.get(b"BIN\0", b"")
        required = set(self.json.get("extensionsRequired", [])) - {"KHR_texture_transform", "KHR_mesh_quantization"}
        if required or self.json.get("animations") or self.json.get("skins"):
            raise Refused(f"animations, skins or required extensions {sorted(required)}")
        self.corners, self.uvs, self.alphas, self.material, self.masks = [], [], [], [], []
        scene = self.json.get("scenes", [{}])[self.json.get("scene", 0)]
        for node in scene.get("nodes", []):
            self.visit(node, np.eye(4))
        self.corners, self.uvs = np.concatenate(self.corners), np.concatenate(self.uvs)
        self.alphas, self.material = np.concatenate(self.alphas), np.concatenate(self.material)

    def visit(self, index, above):
        node = self.json["nodes"][index]
        here = above @ local_matrix(node)
        if "mesh" in node:
            for primitive in self.json["meshes"][node["mesh"]]["primitives"]:
                if primitive.get("mode", 4) >= 4:
                    self.add(primitive, here)
        for child in node.get("children", []):
            self.visit(child, here)

    def add(self, primitive, matrix):
        of = primitive["attributes"]
        points = self.read(of["POSITION"]) @ matrix[:3, :3].T + matrix[:3, 3]
        order, mode = np.arange(len(points)), primitive.get("mode", 4)
        if "indices" in primitive:
            order = self.read(primitive["indices"]).astype(int).ravel()
        if mode == 4:
            corners = order[: len(order) // 3 * 3].reshape(-1, 3)
        else:
            first = order[:-2] if mode == 5 else np.repeat(order[:1], len(order) - 2)
            corners = np.stack([first, order[1:-1], order[2:]], 1)
        mask = self.mask(primitive.get("material"))
        uv, alpha = np.zeros((len(points), 2)), np.ones(len(points))
        if mask and mask["texels"] is not None:
            uv = mask["map"](self.read(of[f"TEXCOORD_{mask['set']}"]))
        if mask and "COLOR_0" in of and self.json["accessors"][of["COLOR_0"]]["type"] == "VEC4":
            alpha = self.read(of["COLOR_0"])[:, 3]
        self.corners.append(points[corners])
        self.uvs.append(uv[corners])
        self.alphas.append(alpha[corners])
        self.material.append(np.full(len(corners), len(self.masks)))
        self.masks.append(mask)

    def read(self, index):
        accessor = self.json["accessors"][index]
        if "sparse" in accessor or "bufferView" not in accessor:
            raise Refused("sparse accessors")
        view, kind = self.json["bufferViews"][accessor["bufferView"]], np.dtype(COMPONENT[accessor["componentType"]])
        shape, stride = (accessor["count"], WIDTH[accessor["type"]]), view.get("byteStride")
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        steps = (stride or kind.itemsize * shape[1], kind.itemsize)
        values = np.ndarray(shape, kind, self.bin, start, steps).astype(float)
        return np.maximum(values / np.iinfo(kind).max, -1) if accessor.get("normalized") else values

    def mask(self, index):
        """None for a surface without holes."""
        material = {} if index is None else self.json["materials"][index]
        if material.get("alphaMode", "OPAQUE") == "OPAQUE":
            return None
        blend, pbr = material["alphaMode"] == "BLEND", material.get("pbrMetallicRoughness", {})
        found = {"cutoff": 0.5 if blend else material.get("alphaCutoff", 0.5), "texels": None}
        found["factor"] = pbr.get("baseColorFactor", [1, 1, 1, 1])[3]
        if (used := pbr.get("baseColorTexture")) is None:
            return found
        texture = self.json["textures"][used["index"]]
        more = used.get("extensions", {}).get("KHR_texture_transform", {})
        view = self.json["bufferViews"][self.json["images"][texture["source"]]["bufferView"]]
        start = view.get("byteOffset", 0)
        image = Image.open(io.BytesIO(self.bin[start : start + view["byteLength"]])).convert("RGBA")
        sampler = self.json["samplers"][texture["sampler"]] if "sampler" in texture else {}
        turn, scale, shift = more.get("rotation", 0), more.get("scale", [1, 1]), more.get("offset", [0, 0])
        rotation = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        found["map"] = lambda uv: uv * scale @ rotation.T + shift
        found["set"] = more.get("texCoord", used.get("texCoord", 0))
        found["wrap"] = sampler.get("wrapS", REPEAT), sampler.get("wrapT", REPEAT)
        found["nearest"] = sampler.get("magFilter") == NEAREST
        found["texels"] = np.asarray(image)[..., 3] / 255.0
        return found

    def add_ground(self, y, half):
        low, high = self.corners.min((0, 1)), self.corners.max((0, 1))
        x, z = (low[0] + high[0]) / 2, (low[2] + high[2]) / 2
        a, b, c, d = ([x + i * half, y, z + k * half] for i, k in ((-1, -1), (-1, 1), (1, 1), (1, -1)))
        self.corners = np.concatenate([self.corners, [[a, b, c], [a, c, d]]])
        self.uvs, self.alphas = np.pad(self.uvs, ((0, 2), (0, 0), (0, 0))), np.pad(self.alphas, ((0, 2), (0, 0)))
        self.material = np.append(self.material, [len(self.masks)] * 2)
        self.masks.append(None)

    def covers(self, triangle, u, v):
        """Whether each hit meets surface rather than a hole."""
        weights, covered = np.stack([1 - u - v, u, v], 1), np.ones(len(triangle), bool)
        for k in np.unique(self.material[triangle]):
            if (mask := self.masks[k]) is None:
                continue
            at = np.nonzero(self.material[triangle] == k)[0]
            alpha = mask["factor"] * (self.alphas[triangle[at]] * weights[at]).sum(1)
            if mask["texels"] is not None:
                alpha *= look_up(mask, (self.uvs[triangle[at]] * weights[at][:, :, None]).sum(1))
            covered[at] = alpha >= mask["cutoff"]
        return covered


def local_matrix(node):
    if "matrix" in node:
        return np.reshape(node["matrix"], (4, 4)).T
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix = np.eye(4)
    matrix[:3, :3] = (np.eye(3) + 2 * w * cross + 2 * cross @ cross) * node.get("scale", (1, 1, 1))
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix


def look_up(mask, uv):
    texels, blended = mask["texels"], 0.0
    place = uv * texels.shape[::-1] - (0.0 if mask["nearest"] else 0.5)
    low = np.floor(place).astype(int)
    part = np.zeros_like(place) if mask["nearest"] else place - low
    for right, down in ((0, 0), (1, 0), (0, 1), (1, 1)):
        column = wrap(low[:, 0] + right, texels.shape[1], mask["wrap"][0])
        row = wrap(low[:, 1] + down, texels.shape[0], mask["wrap"][1])
        weight = np.abs(1 - right - part[:, 0]) * np.abs(1 - down - part[:, 1])
        blended = blended + texels[row, column] * weight
    return blended


def wrap(i, size, mode):
    if mode == CLAMP:
        return np.clip(i, 0, size - 1)
    return np.where(i % (2 * size) < size, i % size, size - 1 - i % size) if mode == MIRROR else i % size
