#pragma once
/// Libraries of this program that few inputs or commands need (no paper section): linked, they
/// would make every start slower.

namespace datasets {

/// The function `name` of the library `file`, which is loaded; null if it lies neither beside the
/// program nor where it was installed.
/// @throws std::runtime_error if it cannot be loaded, or has no such function.
void* loaded_symbol(const char* file, const char* name);

template <class Function>
Function* loaded_function(const char* file, const char* name) {
  return reinterpret_cast<Function*>(loaded_symbol(file, name));
}

}  // namespace datasets
