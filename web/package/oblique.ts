// How bodies meet at an angle with friction, and what the core says of it.

/** How they meet: the speed of approach is that along the normal. With friction the first body comes in at an angle. */
export interface Motion {
  /** c of the first body, or m/s in SI */
  readonly speed: number;
  /** μ of Coulomb's law, by default that of the encounter; without it nothing along the surface counts */
  readonly friction?: number;
  /** between its velocity, relative to what it meets, and the normal, in degrees */
  readonly angle: number;
  /** of both bodies, in c/R of the first, or rad/s in SI, by default 0; they move what touches as the angle does */
  readonly spin?: number;
  readonly spin2?: number;
}

/** ε_t of one angle, with ε. */
export interface AnglePoint {
  angle: number;
  restitution: number;
  error: number;
  tangential: number;
  tangentialError: number;
  converged: boolean;
}

/** What an oblique collision has for every instant: what is along the normal and along the surface, and shares of
 *  the energy. */
type ObliqueInstants = 'time' | 'velocity' | 'tangential' | 'force' | 'friction'
  | 'translation' | 'across' | 'rotation' | 'second_rotation' | 'elastic' | 'friction_loss';

/** One oblique impact in time, at a cutoff. */
export interface ObliqueCollision extends Record<ObliqueInstants, Float64Array> {
  units: Record<'time' | 'velocity' | 'force', string>;
  begin: number;
  end: number;
  /** what moves, as its centre of mass, or the wall or half-space that it meets, sees it: places of centres in radii of
   *  the first, bodies at rest would first touch at x = 0; and by how much they have turned counterclockwise */
  bodies: Record<'x' | 'y' | 'angle', Float64Array>[];
  /** of the contact points along the surface, in radii of the first, in their order; those of rings are their radii */
  places: Float64Array;
  /** what they do, instants × places: 0 stick, 1 and −1 slip along and against y, 2 carry no pressure */
  grips: Int8Array;
}
