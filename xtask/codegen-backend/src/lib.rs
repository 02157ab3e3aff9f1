//! Empty: this package exists so that cargo builds its one dependency, the compiler backend.
