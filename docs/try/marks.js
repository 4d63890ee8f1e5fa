// Bits of a face's mark: what is wrong at the face.

export const isIntersecting = 1, isTurned = 2;
