// Intel Embree 3 behind a small C interface, for `cargo xtask bench-rays`: the same triangles, rays and alpha test as
// our own tracers get, in the layouts that Embree likes best. Loaded by crates/lt-render/benches/rays at run time;
// nothing else in the repository depends on it.
//
// Rays are laid out for a mode beforehand (`lt_embree_lay_out`) and answers read back afterwards
// (`lt_embree_answers`), so that the timed part (`lt_embree_occluded`) is Embree alone.

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <new>
#include <vector>

#include <embree3/rtcore.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace {

// lt_bvh::Triangle.
struct Triangle {
    float v0[3];
    uint32_t i0;
    float v1[3];
    uint32_t i1;
    float v2[3];
    uint32_t i2;
};
constexpr uint32_t NON_OPAQUE = 0x80000000u;

// lt_bvh::Ray.
struct Ray {
    float origin[3], tmin, direction[3], tmax;
};

// lt_shaders::abi::Vertex.
struct Vertex {
    float u, v;
    uint32_t normal, color, material;
};

// lt_shaders::abi::Material.
struct Material {
    float base_color[4];
    float cutoff;
    uint32_t flags, alpha_offset, alpha_size, color_offset, color_size, pad[2];
};
constexpr uint32_t CASTS = 1, NEAREST = 4, WRAP_U_SHIFT = 4, WRAP_V_SHIFT = 6, REPEAT = 0, MIRROR = 1;

static_assert(sizeof(Triangle) == 48 && sizeof(Ray) == 32 && sizeof(Vertex) == 20 && sizeof(Material) == 48,
              "layouts of the Rust side");

// What the alpha test needs of a triangle, gathered so that a test touches one record, one material and the texels.
struct Masked {
    float u[3], v[3], alpha[3];
    uint32_t material;
};

// ---- The alpha test: lt_shaders::surface::covers and lt_shaders::texture, operation by operation. ----

inline float wrap_to_unit(float coordinate, uint32_t wrap) {
    float unit = coordinate;
    if (wrap == REPEAT) {
        unit = coordinate - std::floor(coordinate);
    } else if (wrap == MIRROR) {
        const float period = coordinate - 2.0f * std::floor(coordinate * 0.5f);
        unit = period > 1.0f ? 2.0f - period : period;
    }
    return unit > 0.0f ? (unit < 1.0f ? unit : 1.0f) : 0.0f;
}

struct Axis {
    uint32_t low, high;
    float fraction;
};

inline Axis axis(float coordinate, uint32_t size, uint32_t wrap, bool is_nearest) {
    const float unit = wrap_to_unit(coordinate, wrap);
    const uint32_t last = size - 1;
    const float position = unit * float(size);
    if (is_nearest) {
        const uint32_t at = uint32_t(position);
        const uint32_t texel = at < last ? at : last;
        return {texel, texel, 0.0f};
    }
    const float shifted = position + 0.5f;
    const uint32_t at = uint32_t(shifted);
    const uint32_t upper = at < size ? at : size;
    const uint32_t before = wrap == REPEAT ? last : 0, after = wrap == REPEAT ? 0 : last;
    return {upper == 0 ? before : upper - 1, upper > last ? after : upper, shifted - float(upper)};
}

inline float unorm(const uint8_t* texels, uint32_t index) { return float(texels[index]) * (1.0f / 255.0f); }

inline bool covers(const Material& material, const Masked& triangle, float u, float v, const uint8_t* texels) {
    if (material.cutoff <= 0.0f) return true;
    const float w = 1.0f - u - v;
    float alpha = material.base_color[3] *
                  ((triangle.alpha[0] * w + triangle.alpha[1] * u + triangle.alpha[2] * v) * (1.0f / 255.0f));
    if (material.alpha_size != 0) {
        const float s = triangle.u[0] * w + triangle.u[1] * u + triangle.u[2] * v;
        const float t = triangle.v[0] * w + triangle.v[1] * u + triangle.v[2] * v;
        const uint32_t width = material.alpha_size & 0xffff, height = material.alpha_size >> 16;
        const bool is_nearest = material.flags & NEAREST;
        const Axis x = axis(s, width, material.flags >> WRAP_U_SHIFT & 3, is_nearest);
        const Axis y = axis(t, height, material.flags >> WRAP_V_SHIFT & 3, is_nearest);
        const uint8_t* low = texels + material.alpha_offset + y.low * width;
        const uint8_t* high = texels + material.alpha_offset + y.high * width;
        alpha *= unorm(low, x.low) * ((1.0f - x.fraction) * (1.0f - y.fraction)) +
                 unorm(low, x.high) * (x.fraction * (1.0f - y.fraction)) +
                 unorm(high, x.low) * ((1.0f - x.fraction) * y.fraction) +
                 unorm(high, x.high) * (x.fraction * y.fraction);
    }
    return alpha >= material.cutoff;
}

// ---- Scenes ----

struct Scene {
    RTCScene scene = nullptr;
    std::vector<Masked> masked;
    std::vector<Material> materials;
    std::vector<uint8_t> texels;
    double build_ms = 0.0;
    double build_cpu_ms = 0.0;

    bool accepts(uint32_t triangle, float u, float v) const {
        const Masked& record = masked[triangle];
        const Material& material = materials[record.material];
        return (material.flags & CASTS) != 0 && covers(material, record, u, v, texels.data());
    }

    ~Scene() {
        if (scene) rtcReleaseScene(scene);
    }
};

template <unsigned N>
inline void filter_lanes(const RTCFilterFunctionNArguments* args, unsigned n) {
    const Scene& scene = *static_cast<const Scene*>(args->geometryUserPtr);
    const unsigned lanes = N ? N : n;
    for (unsigned i = 0; i < lanes; ++i) {
        if (args->valid[i] == 0) continue;
        const bool is_hit = scene.accepts(RTCHitN_primID(args->hit, lanes, i), RTCHitN_u(args->hit, lanes, i),
                                          RTCHitN_v(args->hit, lanes, i));
        if (!is_hit) args->valid[i] = 0;
    }
}

void filter(const RTCFilterFunctionNArguments* args) {
    switch (args->N) {
        case 1: return filter_lanes<1>(args, 1);
        case 4: return filter_lanes<4>(args, 4);
        case 8: return filter_lanes<8>(args, 8);
        case 16: return filter_lanes<16>(args, 16);
        default: return filter_lanes<0>(args, args->N);
    }
}

RTCDevice device = nullptr;
RTCError last_error = RTC_ERROR_NONE;

void on_error(void*, RTCError code, const char* text) {
    last_error = code;
    std::fprintf(stderr, "Embree: error %d: %s\n", int(code), text);
}

bool attach(RTCScene scene, const std::vector<float>& corners, const Scene* filtered) {
    if (corners.empty()) return true;
    const size_t vertices = corners.size() / 3;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, vertices);
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, vertices / 3);
    if (positions && indices) {
        std::memcpy(positions, corners.data(), corners.size() * sizeof(float));
        for (size_t i = 0; i < vertices; ++i) static_cast<uint32_t*>(indices)[i] = uint32_t(i);
        if (filtered) {
            rtcSetGeometryUserData(geometry, const_cast<Scene*>(filtered));
            rtcSetGeometryOccludedFilterFunction(geometry, filter);
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
    }
    rtcReleaseGeometry(geometry);
    return positions && indices;
}

// ---- Rays ----

constexpr size_t WIDTH = 16;
// Rays per call of rtcOccluded1M.
constexpr size_t STREAM = 4096;

enum Mode : uint32_t { SINGLE, PACKET_COHERENT, PACKET_INCOHERENT, STREAM_COHERENT, STREAM_INCOHERENT, MODES };

bool is_packet(uint32_t mode) { return mode == PACKET_COHERENT || mode == PACKET_INCOHERENT; }

struct Rays {
    const Ray* source;
    size_t count;
    RTCRay* rays = nullptr;
    RTCRay16* packets = nullptr;

    size_t packet_count() const { return (count + WIDTH - 1) / WIDTH; }
    ~Rays() {
        ::operator delete[](rays, std::align_val_t(64));
        ::operator delete[](packets, std::align_val_t(64));
    }
};

// Denormals to zero while Embree runs, as its documentation advises, and the caller's mode afterwards.
struct FlushDenormals {
#if defined(__x86_64__)
    unsigned saved = _mm_getcsr();
    FlushDenormals() { _mm_setcsr(saved | 0x8040); }
    ~FlushDenormals() { _mm_setcsr(saved); }
#endif
};

}  // namespace

extern "C" {

// Opens the device; 0 if that fails.
int lt_embree_open(uint32_t threads) {
    char config[64];
    std::snprintf(config, sizeof config, "threads=%u,set_affinity=0", threads);
    device = rtcNewDevice(config);
    if (!device) {
        on_error(nullptr, rtcGetDeviceError(nullptr), "rtcNewDevice failed");
        return 0;
    }
    rtcSetDeviceErrorFunction(device, on_error, nullptr);
    return rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_FILTER_FUNCTION_SUPPORTED) != 0;
}

// Version and what this build of Embree can do, in words.
void lt_embree_describe(char* text, uint64_t capacity) {
    const auto has = [](RTCDeviceProperty property) {
        return rtcGetDeviceProperty(device, property) ? "yes" : "no";
    };
    const long version = rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION);
    std::snprintf(text, capacity, "Embree %ld.%ld.%ld (native packets of 4: %s, 8: %s, 16: %s; streams: %s)",
                  version / 10000, version / 100 % 100, version % 100, has(RTC_DEVICE_PROPERTY_NATIVE_RAY4_SUPPORTED),
                  has(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED), has(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED),
                  has(RTC_DEVICE_PROPERTY_RAY_STREAM_SUPPORTED));
}

// Lets scenes made from now on be built by so many threads; 0 if that fails.
int lt_embree_use_threads(uint32_t threads) {
    const RTCDevice before = device;
    if (!lt_embree_open(threads)) {
        device = before;
        return 0;
    }
    rtcReleaseDevice(before);
    return 1;
}

// What building a scene took, from its triangles attached to where rays may be traced.
double lt_embree_build_ms(const void* scene) { return static_cast<const Scene*>(scene)->build_ms; }

// The same as CPU time of all threads.
double lt_embree_build_cpu_ms(const void* scene) { return static_cast<const Scene*>(scene)->build_cpu_ms; }

// A committed scene of default or of low build quality, Embree's fastest, or null. Opaque triangles are a geometry without a filter.
void* lt_embree_scene(const Triangle* triangles, uint64_t count, const Vertex* vertices, const Material* materials,
                      uint64_t material_count, const uint32_t* alpha_texels, uint64_t texel_words, int robust, int fast) {
    last_error = RTC_ERROR_NONE;
    Scene* result = new Scene;
    result->materials.assign(materials, materials + material_count);
    result->texels.resize(texel_words * 4);
    for (uint64_t i = 0; i < texel_words * 4; ++i) result->texels[i] = uint8_t(alpha_texels[i / 4] >> (8 * (i % 4)));
    std::vector<float> opaque, masked;
    for (uint64_t i = 0; i < count; ++i) {
        const Triangle& triangle = triangles[i];
        const bool is_masked = triangle.i0 & NON_OPAQUE;
        std::vector<float>& corners = is_masked ? masked : opaque;
        for (const float* corner : {triangle.v0, triangle.v1, triangle.v2}) {
            corners.insert(corners.end(), corner, corner + 3);
        }
        if (!is_masked) continue;
        Masked record = {};
        const uint32_t indices[3] = {triangle.i0 & ~NON_OPAQUE, triangle.i1, triangle.i2};
        for (int k = 0; k < 3; ++k) {
            const Vertex& vertex = vertices[indices[k]];
            record.u[k] = vertex.u;
            record.v[k] = vertex.v;
            record.alpha[k] = float(vertex.color >> 24);
        }
        record.material = vertices[indices[0]].material;
        result->masked.push_back(record);
    }
    result->scene = rtcNewScene(device);
    if (robust) rtcSetSceneFlags(result->scene, RTC_SCENE_FLAG_ROBUST);
    if (fast) rtcSetSceneBuildQuality(result->scene, RTC_BUILD_QUALITY_LOW);
    const bool attached = attach(result->scene, opaque, nullptr) && attach(result->scene, masked, result);
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    if (attached) rtcCommitScene(result->scene);
    result->build_cpu_ms = 1e3 * double(std::clock() - cpu) / CLOCKS_PER_SEC;
    result->build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (!attached || last_error != RTC_ERROR_NONE) {
        delete result;
        return nullptr;
    }
    return result;
}

void lt_embree_scene_free(void* scene) { delete static_cast<Scene*>(scene); }

// Builds a default scene over an indexed mesh, up to where rays could be traced, and frees it; 0 if that fails.
// The caller's buffers are shared, not copied, and read up to 4 bytes past the last position.
int lt_embree_build(const float* positions, uint64_t vertices, const uint32_t* indices, uint64_t triangles) {
    last_error = RTC_ERROR_NONE;
    RTCScene scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions, 0, 12, vertices);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices, 0, 12, triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    rtcReleaseScene(scene);
    return last_error == RTC_ERROR_NONE;
}

// Remembers `rays`, which must outlive the result.
void* lt_embree_rays(const Ray* rays, uint64_t count) { return new Rays{rays, count}; }

void lt_embree_rays_free(void* rays) { delete static_cast<Rays*>(rays); }

// Fills the buffers that `mode` reads, undoing what an earlier run wrote there.
void lt_embree_lay_out(void* handle, uint32_t mode) {
    Rays& rays = *static_cast<Rays*>(handle);
    if (is_packet(mode)) {
        if (!rays.packets) {
            const size_t bytes = (rays.packet_count() + 1) * sizeof(RTCRay16);
            rays.packets = static_cast<RTCRay16*>(::operator new[](bytes, std::align_val_t(64)));
        }
        for (size_t i = 0; i < rays.packet_count() * WIDTH; ++i) {
            // Lanes past the end repeat the last ray; they are masked off.
            const Ray& from = rays.source[i < rays.count ? i : rays.count - 1];
            RTCRay16& to = rays.packets[i / WIDTH];
            const size_t lane = i % WIDTH;
            to.org_x[lane] = from.origin[0], to.org_y[lane] = from.origin[1], to.org_z[lane] = from.origin[2];
            to.dir_x[lane] = from.direction[0], to.dir_y[lane] = from.direction[1], to.dir_z[lane] = from.direction[2];
            to.tnear[lane] = from.tmin, to.tfar[lane] = from.tmax, to.time[lane] = 0.0f;
            to.mask[lane] = ~0u, to.id[lane] = unsigned(i), to.flags[lane] = 0;
        }
        return;
    }
    if (!rays.rays) {
        const size_t bytes = (rays.count + 1) * sizeof(RTCRay);
        rays.rays = static_cast<RTCRay*>(::operator new[](bytes, std::align_val_t(64)));
    }
    for (size_t i = 0; i < rays.count; ++i) {
        const Ray& from = rays.source[i];
        RTCRay& to = rays.rays[i];
        to.org_x = from.origin[0], to.org_y = from.origin[1], to.org_z = from.origin[2];
        to.dir_x = from.direction[0], to.dir_y = from.direction[1], to.dir_z = from.direction[2];
        to.tnear = from.tmin, to.tfar = from.tmax, to.time = 0.0f;
        to.mask = ~0u, to.id = unsigned(i), to.flags = 0;
    }
}

// Traces rays `begin` to `end`; `begin` must be a multiple of 4096. Distinct ranges may run on distinct threads.
void lt_embree_occluded(const void* scene_handle, void* rays_handle, uint32_t mode, uint64_t begin, uint64_t end) {
    const FlushDenormals flush;
    const RTCScene scene = static_cast<const Scene*>(scene_handle)->scene;
    Rays& rays = *static_cast<Rays*>(rays_handle);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    const bool is_coherent = mode == PACKET_COHERENT || mode == STREAM_COHERENT;
    context.flags = is_coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    if (mode == SINGLE) {
        for (size_t i = begin; i < end; ++i) rtcOccluded1(scene, &context, &rays.rays[i]);
    } else if (is_packet(mode)) {
        alignas(64) int valid[WIDTH];
        for (size_t i = begin; i < end; i += WIDTH) {
            for (size_t lane = 0; lane < WIDTH; ++lane) valid[lane] = i + lane < end ? -1 : 0;
            rtcOccluded16(valid, scene, &context, &rays.packets[i / WIDTH]);
        }
    } else {
        for (size_t i = begin; i < end; i += STREAM) {
            const size_t count = end - i < STREAM ? end - i : STREAM;
            rtcOccluded1M(scene, &context, &rays.rays[i], unsigned(count), sizeof(RTCRay));
        }
    }
}

// 1 for each ray that the last run of `mode` found blocked, else 0. Embree marks those by a tfar of -inf.
void lt_embree_answers(const void* handle, uint32_t mode, uint8_t* out) {
    const Rays& rays = *static_cast<const Rays*>(handle);
    for (size_t i = 0; i < rays.count; ++i) {
        const float tfar = is_packet(mode) ? rays.packets[i / WIDTH].tfar[i % WIDTH] : rays.rays[i].tfar;
        out[i] = tfar < 0.0f ? 1 : 0;
    }
}

}  // extern "C"
