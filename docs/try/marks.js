// Bits of a face's mark, a number from 0 to 3: what is wrong at the face.

export const isIntersecting = 1, isTurned = 2;
