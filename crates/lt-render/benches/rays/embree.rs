//! Intel Embree through xtask/embree/embree.cpp, loaded at run time.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::marker::PhantomData;
use std::ops::Range;

use libloading::Library;
use lt_bvh::{Ray, Triangle};
use lt_math::glam::Vec3;
use lt_shaders::abi::{Material, Vertex};

use super::Outcome;
use super::measure::{BATCH, Family, Way};
use super::places::Place;

/// Names the compiled library; `cargo xtask bench-rays` sets it.
pub const LIBRARY_VARIABLE: &str = "LT_EMBREE_LIBRARY";

/// Threads that build.
pub const BUILD_THREADS: u32 = 2;

/// Modes as the library numbers them, and their columns.
const MODES: [(u32, &str); 5] = [
    (0, "Embree, single"),
    (1, "Embree, packet 16 coherent"),
    (2, "Embree, packet 16 incoherent"),
    (3, "Embree, stream coherent"),
    (4, "Embree, stream incoherent"),
];

type NewScene = unsafe extern "C" fn(
    *const Triangle,
    u64,
    *const Vertex,
    *const Material,
    u64,
    *const u32,
    u64,
    c_int,
    c_int,
) -> *mut c_void;
type Build = unsafe extern "C" fn(*const Vec3, u64, *const [u32; 3], u64) -> c_int;
type BuildMs = unsafe extern "C" fn(*const c_void) -> f64;
type UseThreads = unsafe extern "C" fn(u32) -> c_int;
type Free = unsafe extern "C" fn(*mut c_void);
type NewRays = unsafe extern "C" fn(*const Ray, u64) -> *mut c_void;
type LayOut = unsafe extern "C" fn(*mut c_void, u32);
type Occluded = unsafe extern "C" fn(*const c_void, *mut c_void, u32, u64, u64);
type Answers = unsafe extern "C" fn(*const c_void, u32, *mut bool);

/// How well trees are built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    /// Embree's default.
    Default,
    /// Its fastest.
    Fast,
}

/// The library, its device opened.
pub struct Embree {
    new_scene: NewScene,
    free_scene: Free,
    build_ms: BuildMs,
    build_cpu_ms: BuildMs,
    use_threads: UseThreads,
    build: Build,
    new_rays: NewRays,
    free_rays: Free,
    lay_out: LayOut,
    occluded: Occluded,
    answers: Answers,
    /// Version and abilities.
    pub description: String,
}

impl Embree {
    /// The library that the environment names; `None` if it names none.
    ///
    /// # Errors
    /// It names one that cannot be loaded or opened.
    pub fn from_environment() -> Outcome<Option<Self>> {
        let Some(path) = std::env::var_os(LIBRARY_VARIABLE).filter(|path| !path.is_empty()) else {
            return Ok(None);
        };
        // SAFETY: whoever sets the variable vouches for the library; ours runs no code when it is loaded, and the
        // signatures below are those of xtask/embree/embree.cpp.
        unsafe {
            // Never unloaded: the threads that Embree builds with outlive its device, and run the library's code.
            let library: &'static Library = Box::leak(Box::new(Library::new(path)?));
            let open = library.get::<unsafe extern "C" fn(u32) -> c_int>(b"lt_embree_open\0")?;
            if open(BUILD_THREADS) == 0 {
                return Err("Embree's device cannot be opened, or lacks filter functions".into());
            }
            let mut text = [0 as c_char; 256];
            library.get::<unsafe extern "C" fn(*mut c_char, u64)>(b"lt_embree_describe\0")?(
                text.as_mut_ptr(),
                text.len() as u64,
            );
            Ok(Some(Embree {
                new_scene: *library.get(b"lt_embree_scene\0")?,
                free_scene: *library.get(b"lt_embree_scene_free\0")?,
                build_ms: *library.get(b"lt_embree_build_ms\0")?,
                build_cpu_ms: *library.get(b"lt_embree_build_cpu_ms\0")?,
                use_threads: *library.get(b"lt_embree_use_threads\0")?,
                build: *library.get(b"lt_embree_build\0")?,
                new_rays: *library.get(b"lt_embree_rays\0")?,
                free_rays: *library.get(b"lt_embree_rays_free\0")?,
                lay_out: *library.get(b"lt_embree_lay_out\0")?,
                occluded: *library.get(b"lt_embree_occluded\0")?,
                answers: *library.get(b"lt_embree_answers\0")?,
                description: CStr::from_ptr(text.as_ptr()).to_string_lossy().into_owned(),
            }))
        }
    }

    /// Lets scenes made from now on be built by so many threads.
    ///
    /// # Errors
    /// Embree has no such device.
    pub fn use_threads(&self, threads: u32) -> Outcome<()> {
        // SAFETY: no call of the library's is under way; scenes keep their own device.
        let opened = unsafe { (self.use_threads)(threads) };
        if opened == 0 { Err(format!("Embree opens no device of {threads} threads").into()) } else { Ok(()) }
    }

    /// Builds a scene over the triangles of a place, in this order.
    ///
    /// # Errors
    /// Embree refuses.
    pub fn scene(
        &self,
        place: &Place,
        triangles: &[Triangle],
        is_robust: bool,
        quality: Quality,
    ) -> Outcome<EmbreeScene<'_>> {
        let packed = &place.packed;
        let (materials, texels) = (packed.materials(), packed.alpha_texels());
        // SAFETY: pointers and lengths belong together, and the library copies what it keeps. Vertex and material
        // indices are in range, as PackedScene makes them.
        let scene = unsafe {
            (self.new_scene)(
                triangles.as_ptr(),
                triangles.len() as u64,
                packed.vertices().as_ptr(),
                materials.as_ptr(),
                materials.len() as u64,
                texels.as_ptr(),
                texels.len() as u64,
                c_int::from(is_robust),
                c_int::from(quality == Quality::Fast),
            )
        };
        if scene.is_null() {
            return Err(format!("{}: Embree refuses the scene", place.name).into());
        }
        Ok(EmbreeScene { embree: self, scene })
    }

    /// Builds over an indexed mesh and throws the tree away. `positions` must have one more element than the mesh has
    /// vertices: Embree reads 16 bytes at each.
    ///
    /// # Errors
    /// Embree refuses.
    pub fn build(&self, positions: &[Vec3], indices: &[[u32; 3]]) -> Outcome<()> {
        let vertices = positions.len() - 1;
        assert!(indices.iter().flatten().all(|&i| (i as usize) < vertices), "an index is out of range");
        // SAFETY: the buffers outlive the call, their lengths are given, the last vertex is followed by another, and
        // every index was checked.
        let built = unsafe {
            (self.build)(positions.as_ptr(), vertices as u64, indices.as_ptr(), indices.len() as u64)
        };
        if built == 0 { Err("Embree refuses the mesh".into()) } else { Ok(()) }
    }
}

/// A scene of Embree's.
pub struct EmbreeScene<'e> {
    embree: &'e Embree,
    scene: *mut c_void,
}

impl<'e> EmbreeScene<'e> {
    /// What building it took, ms.
    pub fn build_ms(&self) -> f64 {
        // SAFETY: made by `new_scene` and not freed yet.
        unsafe { (self.embree.build_ms)(self.scene) }
    }

    /// The same as CPU time of all threads.
    pub fn build_cpu_ms(&self) -> f64 {
        // SAFETY: made by `new_scene` and not freed yet.
        unsafe { (self.embree.build_cpu_ms)(self.scene) }
    }

    /// Prepares a list of rays.
    pub fn rays<'a>(&'a self, rays: &'a [Ray]) -> EmbreeRays<'a> {
        // SAFETY: the list outlives the handle by the lifetime of the result.
        let handle = unsafe { (self.embree.new_rays)(rays.as_ptr(), rays.len() as u64) };
        EmbreeRays { scene: self, handle, rays: PhantomData }
    }
}

impl Drop for EmbreeScene<'_> {
    fn drop(&mut self) {
        // SAFETY: made by `new_scene`, freed once; every EmbreeRays borrows self.
        unsafe { (self.embree.free_scene)(self.scene) }
    }
}

/// A list of rays in Embree's layouts.
pub struct EmbreeRays<'a> {
    scene: &'a EmbreeScene<'a>,
    handle: *mut c_void,
    rays: PhantomData<&'a [Ray]>,
}

impl EmbreeRays<'_> {
    /// Every mode of Embree's on this list.
    pub fn ways(&self) -> Vec<Box<dyn Way + '_>> {
        let way = |&(mode, name)| -> Box<dyn Way + '_> { Box::new(Mode { rays: self, mode, name }) };
        MODES.iter().map(way).collect()
    }
}

impl Drop for EmbreeRays<'_> {
    fn drop(&mut self) {
        // SAFETY: made by `new_rays`, freed once; every Mode borrows self.
        unsafe { (self.scene.embree.free_rays)(self.handle) }
    }
}

struct Mode<'a> {
    rays: &'a EmbreeRays<'a>,
    mode: u32,
    name: &'static str,
}

// SAFETY: Embree's scenes may be traced from any number of threads. The ray buffers are written in ranges that
// `measure` hands to one thread each; `prepare` and `collect` run while no thread traces.
unsafe impl Sync for Mode<'_> {}

impl Way for Mode<'_> {
    fn name(&self) -> &str {
        self.name
    }

    fn family(&self) -> Family {
        Family::Embree
    }

    fn prepare(&self) {
        // SAFETY: a live handle and a mode of the library's.
        unsafe { (self.rays.scene.embree.lay_out)(self.rays.handle, self.mode) }
    }

    fn trace(&self, range: Range<usize>, _: &mut [bool]) {
        assert!(range.start.is_multiple_of(BATCH), "batches start at whole streams");
        let scene = self.rays.scene;
        // SAFETY: live handles; `measure` prepares first and asks for ranges within the list.
        unsafe {
            (scene.embree.occluded)(
                scene.scene,
                self.rays.handle,
                self.mode,
                range.start as u64,
                range.end as u64,
            );
        }
    }

    fn collect(&self, out: &mut [bool]) {
        // SAFETY: a live handle; `out` has the length of the list, and the library writes only 0 and 1.
        unsafe { (self.rays.scene.embree.answers)(self.rays.handle, self.mode, out.as_mut_ptr()) }
    }
}
