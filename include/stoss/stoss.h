#ifndef STOSS_STOSS_H
#define STOSS_STOSS_H

/**
 * @file
 * The C interface of the library: bodies, contacts, the coefficient of restitution, the function of the speed, oblique
 * impacts with friction, and rows of bodies.
 *
 * It is C89, and C++ and bind(C) of Fortran (stoss.f90) can use it. Link it with `pkg-config --libs stoss`.
 *
 * Functions that can fail return a status, STOSS_OK or another, and write to their outputs only where they say so.
 * The caller owns what a function makes and frees it once; nothing notices if it is freed twice.
 * Handles do not change: any number of threads may use one. Nothing is printed, and no C++ exception leaves.
 *
 * Sizes and materials are in any consistent units, those of all bodies the same. Speeds are speeds of approach in
 * c = sqrt(young/density) of the first body; results are in its units of length R (radius, length of a rod), time R/c
 * and force m c^2/R.
 */

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a function returns. */
#define STOSS_OK 0
#define STOSS_INVALID_INPUT 1 /**< an argument out of its range, or NULL */
#define STOSS_NOT_CONVERGED 2 /**< the accuracy is out of reach */
#define STOSS_OUT_OF_MEMORY 3
#define STOSS_INTERRUPTED 4 /**< by the caller's own poll */
#define STOSS_FAILED 5      /**< anything else: of the system, as no thread to be had */

/** Why the last function failed in this thread: one line, valid until the next one fails; "" before. */
const char* stoss_message(void);

/** Templates of a refused argument. */
#define STOSS_OUT_OF_RANGE 1 /**< name: got ..., allowed ... (hint) */
#define STOSS_MISSING 2      /**< name: missing, what is needed (hint) */
#define STOSS_CONFLICT 3     /**< name: why it does not go with the rest (hint) */

/** The parts of the message of a function that returned STOSS_INVALID_INPUT; those that it does not have are "". */
typedef struct stoss_refusal {
  int kind; /**< STOSS_OUT_OF_RANGE, STOSS_MISSING or STOSS_CONFLICT; 0 after another status */
  const char* name;
  const char* got;
  const char* allowed; /**< also what is missing, or what does not go together */
  const char* hint;
} stoss_refusal;

/** The parts of stoss_message() in this thread, valid as long as it. */
stoss_refusal stoss_last_refusal(void);

/** Version of the library, as in "2.0.0": that of what is linked, at run time. */
const char* stoss_version(void);

/** An elastic or rigid body. */
typedef struct stoss_body stoss_body;

/**
 * Makes a disk. Its constants are those of two dimensions: in plane stress those of the solid.
 * @param poisson   2-D Poisson's ratio, -0.95 to 0.995
 * @param loss_time eta of stress = (1 + eta d/dt) elastic stress, in the unit of time of the others; 0: lossless
 */
int stoss_disk_make(double poisson, double radius, double young, double density, double loss_time, stoss_body** body);

/** Makes a sphere. @param poisson -0.95 to 0.4999 */
int stoss_sphere_make(double poisson, double radius, double young, double density, double loss_time, stoss_body** body);

/** Makes a hollow sphere. @param inner radius of the concentric hole over that of the sphere, 0 (solid) to 0.99 */
int stoss_hollow_sphere_make(double poisson, double inner, double radius, double young, double density,
                             double loss_time, stoss_body** body);

/** Makes a thin rod, which meets with one end. */
int stoss_rod_make(double length, double young, double density, double area, double loss_time, stoss_body** body);

/** Makes a half-space, the second body of a contact with a sphere. @param poisson -0.95 to 0.4999 */
int stoss_half_space_make(double poisson, double young, double density, double loss_time, stoss_body** body);

/** Makes a half-plane, the second body of a contact with a disk. @param poisson 2-D, -0.95 to 0.995 */
int stoss_half_plane_make(double poisson, double young, double density, double loss_time, stoss_body** body);

/**
 * Makes a plate, free on both faces, the second body of a contact with a sphere; one of layers: stoss_open.
 * @param poisson -0.95 to 0.4999
 */
int stoss_plate_make(double thickness, double poisson, double young, double density, double loss_time,
                     stoss_body** body);

/** Makes a strip, a plate in the plane, the second body of a contact with a disk. @param poisson 2-D, -0.95 to 0.995 */
int stoss_strip_make(double thickness, double poisson, double young, double density, double loss_time,
                     stoss_body** body);

/**
 * Makes a body of a material that relaxes: E(t) = E(0) (1 - sum of shares (1 - exp(-t/time))), where E(0) is the
 * modulus of the elastic body. Poisson's ratio stays the same.
 * @param shares `count` of them, above 0, at most 1 in sum
 * @param times  `count` of them, in the unit of time of the numbers of the body
 * @param count  0 to 20
 */
int stoss_relaxing_make(const stoss_body* elastic, const double* shares, const double* times, size_t count,
                        stoss_body** body);

/**
 * Makes a body with a rough face, whose elastic asperities push with p0 exp(-gap/u0); of two faces u0^2 = u1^2 + u2^2.
 * @param smooth of any kind; a relaxing or a rigid one is made before
 * @param u0     0 (smooth) to 1000 in the unit of the sizes of the body; 0.45 of the rms height of its asperities
 */
int stoss_rough_make(const stoss_body* smooth, double u0, stoss_body** body);

/** Makes the rigid body of the size and mass of a disk or a sphere; it meets an elastic one. */
int stoss_rigid_make(const stoss_body* elastic, stoss_body** body);

/** Frees a body; NULL is none. Contacts that were made of it remain. */
void stoss_body_free(stoss_body* body);

/** Who meets whom. It keeps the modes that it has computed. */
typedef struct stoss_contact stoss_contact;

/** Makes the contact of a disk, sphere or rod, not a rigid one, with a hard wall. */
int stoss_wall_contact_make(const stoss_body* body, stoss_contact** contact);

/** Makes the contact of two bodies; they may be the same. */
int stoss_pair_contact_make(const stoss_body* first, const stoss_body* second, stoss_contact** contact);

/**
 * Makes the contact of an encounter that a JSON document describes, as in
 *
 *     {"first": {"kind": "sphere", "radius": 0.005, "material": "structural steel"},
 *      "against": {"kind": "half-space", "material": "glass"}}
 *
 * `stoss schema` prints the JSON Schema of such documents. What has a material is in SI, and stoss_speed_unit says what
 * to divide speeds by; otherwise sizes and materials are ratios to those of the first body.
 */
int stoss_open(const char* json, stoss_contact** contact);

/** c of the first body in m/s if it has a material, otherwise 1. */
double stoss_speed_unit(const stoss_contact* contact);

/** Frees a contact; NULL is none. */
void stoss_contact_free(stoss_contact* contact);

/** What a long computation calls on the caller's thread every 50 ms or sooner; not 0 ends it: STOSS_INTERRUPTED. */
typedef int (*stoss_poll)(void* context);

/** How a long computation runs. Where it is NULL: on all processors, without a poll. */
typedef struct stoss_control {
  int threads;     /**< 0: as many as the machine has; results do not depend on it */
  stoss_poll poll; /**< NULL: none */
  void* context;   /**< for the poll */
} stoss_control;

/** A number with its estimated error; an infinite error is unknown. */
typedef struct stoss_estimate {
  double value;
  double error;
} stoss_estimate;

/** The coefficient of restitution at one speed, eps, and the impact that led to it. */
typedef struct stoss_result {
  double speed;
  stoss_estimate restitution;     /**< eps */
  stoss_estimate lost_fraction;   /**< 1 - eps^2 */
  stoss_estimate contact_time;    /**< R/c */
  stoss_estimate max_force;       /**< m c^2/R; a ball is stiffer than Hertz' contact: at a wall 6 % above at 0.004 c */
  stoss_estimate max_compression; /**< R */
  int converged;                  /**< 1, or 0 where the tolerance is not met */
} stoss_result;

/** Tolerances that are good for most purposes. */
#define STOSS_TOLERANCE 1e-3
#define STOSS_ABSOLUTE 1e-6

/**
 * Computes the coefficient of restitution at each of `count` speeds.
 *
 * A speed whose tolerance is not met does not end the others. The status is then STOSS_NOT_CONVERGED, its `converged`
 * is 0, and it has the best values, or NaN where there are none. All other failures leave `results` as it was.
 * @param speeds    1e-8 to 1 c
 * @param tolerance error of 1 - eps^2 over 1 - eps^2, 1e-15 to 0.5
 * @param absolute  or error of 1 - eps^2 that is small enough in any case, 0 to 0.5
 * @param control   or NULL
 * @param results   `count` of them
 */
int stoss_curve(const stoss_contact* contact, const double* speeds, size_t count, double tolerance, double absolute,
                const stoss_control* control, stoss_result* results);

/** How two surfaces meet that move along each other: along y, with x along the normal from the first body. */
typedef struct stoss_obliquity {
  double speed;       /**< of approach along the normal, 1e-8 to 1 c */
  double tangential;  /**< velocity of the centre of the first body along y relative to the second, -1 to 1 c */
  double spin;        /**< of the first body, c/R: positive moves its foremost point along +y */
  double second_spin; /**< of the second body, c/R of the first: positive moves its foremost point along -y */
  double friction;    /**< coefficient of Coulomb's law, 0 to 5 */
} stoss_obliquity;

/**
 * Reads how two surfaces meet from a JSON document, as in
 *
 *     {"speed": 1, "angle": 45, "spin": 0, "second_spin": 0, "friction": 0.3}
 *
 * with `tangential` in place of the angle, which is in degrees. Where the contact is in SI, these are in m/s and rad/s.
 * @param obliquity in units of the first body
 */
int stoss_collision(const stoss_contact* contact, const char* json, stoss_obliquity* obliquity);

/** A collision rule at one obliquity, in units of the first body. */
typedef struct stoss_oblique_result {
  stoss_obliquity before;
  double sliding;                        /**< s = tangential + spin R + second_spin R2, at which the surfaces slide */
  stoss_estimate restitution;            /**< of the velocity along the normal */
  stoss_estimate tangential_restitution; /**< -s'/s; where s is 0 it is 0, with an infinite error */
  stoss_estimate sliding_after;          /**< s' */
  stoss_estimate tangential_after;       /**< c */
  stoss_estimate spin_after;             /**< c/R */
  stoss_estimate second_spin_after;      /**< c/R */
  stoss_estimate friction_loss;          /**< share of the initial energy that became heat of friction */
  stoss_estimate vibration;              /**< share of it with which the bodies vibrate */
  /* What the errors do not contain: pressure and friction are taken not to change each other in spheres. 0 of equal
     bodies and of disks, NaN where unknown. */
  double dundurs;                         /**< Dundurs' constant of unlike spheres */
  double coupling_restitution;            /**< change of the restitution of a central impact by that coupling */
  double coupling_tangential_restitution; /**< of tangential_restitution */
  double coupling_sliding_after;          /**< of s' */
  int converged;                          /**< 1, or 0 where the tolerance is not met */
} stoss_oblique_result;

/** A tolerance of oblique impacts that is good for most purposes. */
#define STOSS_OBLIQUE_TOLERANCE 1e-2

/**
 * Computes the collision rule at each of `count` obliquities, as stoss_curve does. Of spheres, those that follow one
 * another at one speed share most of the work. Rods, and exponential walls, take no friction.
 * @param tolerance error of s' over |s| or, if larger, the friction times the speed, 1e-6 to 0.5
 * @param control   or NULL
 * @param results   `count` of them
 */
int stoss_oblique(const stoss_contact* contact, const stoss_obliquity* obliquities, size_t count, double tolerance,
                  const stoss_control* control, stoss_oblique_result* results);

/**
 * Computes the velocities of bodies on one line after all their contacts, of a row that a JSON document describes, as
 * in
 *
 *     {"bodies": [{"kind": "sphere", "radius": 0.01, "material": "glass"}, {"kind": "sphere", "radius": 0.02,
 *      "material": "glass"}], "before": "wall", "after": "wall", "gaps": [0, 1e-6, 0]}
 *
 * Where the tolerance is not met the status is STOSS_NOT_CONVERGED, and `velocities` has the best values.
 * @param speeds     of the bodies to the right, in m/s if the first has a material, else in its c
 * @param count      of the bodies
 * @param tolerance  error of each velocity over the greatest difference of speeds, 1e-6 to 1; 1e-3 is good for most
 *                   purposes
 * @param control    or NULL
 * @param velocities `count` of them, to the right, in the unit of the speeds
 */
int stoss_row(const char* json, const double* speeds, size_t count, double tolerance, const stoss_control* control,
              stoss_estimate* velocities);

/** The coefficient of restitution as a function of the speed. */
typedef struct stoss_function stoss_function;

/** Values of a function beyond its range. */
#define STOSS_BEYOND_ERROR 0 /**< STOSS_INVALID_INPUT */
#define STOSS_BEYOND_CLAMP                                                                                          \
  1                        /**< the value at the nearer end, at speed 0 that at the slowest, with an infinite error \
                            */
#define STOSS_BEYOND_LAW 2 /**< below, the law of slow impacts; above, STOSS_INVALID_INPUT */

/**
 * Makes eps(v) with an error of at most `error`, interpolation included.
 * @param slowest 1e-8 to 1 c
 * @param fastest above it, to 1 c
 * @param error   maximum error of eps at any speed, 1e-7 to 0.1
 * @param beyond  STOSS_BEYOND_ERROR, STOSS_BEYOND_CLAMP or, of a disk or sphere at a wall, two equal ones, and
 *                a sphere on a half-space, STOSS_BEYOND_LAW
 * @param control or NULL
 */
int stoss_function_make(const stoss_contact* contact, double slowest, double fastest, double error, int beyond,
                        const stoss_control* control, stoss_function** function);

/**
 * Evaluates eps at each of `count` speeds, whose signs do not count; 0 lies below every range.
 * @param values `count` of them; NaN, with an infinite error, at speeds that are not finite and at those beyond the
 *               range where that is an error, which the status reports
 * @param errors `count` of them, or NULL, which is faster
 */
int stoss_function_evaluate(const stoss_function* function, const double* speeds, size_t count, double* values,
                            double* errors);

/** Range of the function, and its maximum error within. Each output may be NULL. */
int stoss_function_range(const stoss_function* function, double* slowest, double* fastest, double* greatest_error);

/** Frees a function; NULL is none. */
void stoss_function_free(stoss_function* function);

#ifdef __cplusplus
}
#endif

#endif
