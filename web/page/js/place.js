/**
 * The folder of the scripts, for what is loaded by name: web/build.sh puts them together in other
 * files of another folder.
 */
export const SCRIPTS = new URL("./", import.meta.url);
