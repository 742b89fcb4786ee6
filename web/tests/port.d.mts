export declare const PORT: number;
