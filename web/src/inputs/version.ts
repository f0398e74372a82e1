// The version of stoss, which the build takes from CMakeLists.txt.
declare const STOSS_VERSION: string;

export const version = STOSS_VERSION;
