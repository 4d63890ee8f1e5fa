/// The exact point of a contact, by what defines it.
#pragma once

#include "tm/clean/intersect/contacts.h"
#include "tm/geometry/exact_point.h"

namespace transformesh {

ExactPoint contact_point(const Soup& soup, const ExactGeometry& geometry, Index first, Index second,
                         Contact contact);

}  // namespace transformesh
