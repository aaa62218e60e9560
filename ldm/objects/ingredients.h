#pragma once
/// What an object's motion is measured from, so that each part can be left out (no paper section;
/// docs/objects.md, study `objects`).

namespace ldm {

/// All of it, unless said otherwise.
struct Ingredients {
  bool margin = true;      ///< returns beyond the map's border, too: no object is cut off there
  bool outline = true;     ///< surfaces and edges; else an object is where its centre is
  bool slices = true;      ///< columns end at slices; else they reach from bottom to top
  bool edges = true;       ///< where an object ends, it is measured across the line of sight
  bool centre = true;      ///< the way of the centre steadies what surfaces leave open
  bool manoeuvres = true;  ///< four ways to move; else one, as any Kalman filter
  bool shift = true;       ///< what all objects of a scan share is an error of its pose
  bool one_return = true;  ///< one return on an object makes a voxel occupied
};

}  // namespace ldm
