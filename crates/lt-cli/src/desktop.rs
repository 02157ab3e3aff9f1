//! Where there is no desktop (Docker, CI), nothing is asked of one.

use std::{env, path::Path};

/// Turns off Mesa's Vulkan layer that asks a Wayland desktop for its GPU, where there is none to ask: it prints an error each time, and
/// `lt` ranks adapters by itself. Whoever tells that layer what to select keeps it.
///
/// To be called before any thread is started.
pub fn is_not_asked_where_there_is_none() {
    let has_sockets = env::var_os("XDG_RUNTIME_DIR").is_some_and(|dir| Path::new(&dir).is_absolute());
    if has_sockets || env::var_os("MESA_VK_DEVICE_SELECT").is_some() {
        return;
    }
    // SAFETY: no other thread reads or writes the environment, since there is none yet.
    unsafe { env::set_var("NODEVICE_SELECT", "1") };
}
